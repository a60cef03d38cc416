// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface.h"

#include <utility>

#include "laplacian_lines/precompute.h"

namespace python_module {

using namespace laplacian_lines;

Surface::Surface(TriangleMesh mesh, const PrecomputeOptions& options, const Progress& progress)
    : mesh_(std::move(mesh)),
      field_(precompute(mesh_, options, progress)),
      wants_derivatives_(options.curvature_derivatives) {}

Field Surface::field() const {
    const std::lock_guard using_parts(parts_);
    Field field = field_;
    if (!wants_derivatives_) {
        field.smooth_curvatures.clear();
        field.curvature_derivatives.clear();
    }
    return field;
}

const LineExtractor& Surface::extractor(const LineStyle& style, const Progress& progress) {
    if (!extractor_) extractor_ = std::make_unique<LineExtractor>(mesh_, field_, progress);
    if (style.shows.needs_derivatives() && !field_.has_derivatives()) {
        Field field = field_;  // as a whole or not at all
        add_curvature_derivatives(mesh_, field, progress);
        extractor_->add_derivatives(mesh_, field);
        field_ = std::move(field);
    }
    return *extractor_;
}

LineSet Surface::lines(const View& view, const LineStyle& style, const Progress& progress) {
    const std::lock_guard using_parts(parts_);
    ExtractionScratch scratch;
    LineSet lines;
    extractor(style, progress).extract(view, style, scratch, lines);
    return lines;
}

std::vector<SightLine> Surface::visible_lines(const View& view, const LineStyle& style,
                                              SightOptions options, const Progress& progress) {
    const std::lock_guard using_parts(parts_);
    if (!visibility_) visibility_ = std::make_unique<LineVisibility>(mesh_, progress);
    ExtractionScratch scratch;
    const LineSet lines = extract_on_surface(extractor(style, progress), view, style, scratch);
    options.shows = style.shows;
    options.line_smoothing = style.line_smoothing;
    options.shortest_contour = style.shortest_contour;
    return visibility_->look(view, {lines}, options, progress);
}

}  // namespace python_module
