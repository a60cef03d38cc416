// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface.h"

#include <mutex>
#include <utility>

#include "laplacian_lines/precompute.h"

namespace python_module {

using namespace laplacian_lines;

Surface::Surface(TriangleMesh mesh, const PrecomputeOptions& options, const Progress& progress)
    : mesh_(std::move(mesh)),
      field_(precompute(mesh_, options, progress)),
      wants_derivatives_(options.curvature_derivatives) {}

Field Surface::field() const {
    const std::shared_lock reading(parts_);
    Field field = field_;
    if (!wants_derivatives_) {
        field.smooth_curvatures.clear();
        field.curvature_derivatives.clear();
    }
    return field;
}

template <class Read>
auto Surface::with_extractor(const LineStyle& style, const Progress& progress, const Read& read) {
    const auto is_ready = [&] {
        return extractor_ && (field_.has_derivatives() || !style.shows.needs_derivatives());
    };
    std::shared_lock reading(parts_);
    if (!is_ready()) {
        reading.unlock();
        {
            const std::unique_lock writing(parts_);
            if (!extractor_) extractor_ = std::make_unique<LineExtractor>(mesh_, field_, progress);
            if (!is_ready()) {
                Field field = field_;
                add_curvature_derivatives(mesh_, field, progress);
                extractor_->add_derivatives(mesh_, field);
                field_.smooth_curvatures = std::move(field.smooth_curvatures);
                field_.curvature_derivatives = std::move(field.curvature_derivatives);
            }
        }
        reading.lock();
    }
    return read(std::as_const(*extractor_));
}

LineSet Surface::lines(const View& view, const LineStyle& style, const Progress& progress) {
    return with_extractor(style, progress, [&](const LineExtractor& extractor) {
        ExtractionScratch scratch;
        LineSet lines;
        extractor.extract(view, style, scratch, lines);
        return lines;
    });
}

std::vector<SightLine> Surface::visible_lines(const View& view, const LineStyle& style,
                                              SightOptions options, const Progress& progress) {
    {
        const std::unique_lock writing(parts_);
        if (!visibility_) visibility_ = std::make_unique<LineVisibility>(mesh_, progress);
    }
    const LineSet lines = with_extractor(style, progress, [&](const LineExtractor& extractor) {
        ExtractionScratch scratch;
        return extract_on_surface(extractor, view, style, scratch);
    });
    options.shows = style.shows;
    options.line_smoothing = style.line_smoothing;
    options.shortest_contour = style.shortest_contour;
    return visibility_->look(view, {lines}, options, progress);
}

}  // namespace python_module
