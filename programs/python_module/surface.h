// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_style.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/progress.h"
#include "line_drawing/view_strokes.h"

namespace python_module {

using namespace laplacian_lines;

/// A mesh, its field, and what lines need of them, computed on demand. Thread-safe.
class Surface {
public:
    /// @throws laplacian_lines::Error as precompute()
    Surface(TriangleMesh mesh, const PrecomputeOptions& options, const Progress& progress)
        : mesh_(std::move(mesh)),
          field_(precompute(mesh_, options, progress)),
          has_own_kernel_(options.kernel_size > 0),
          wants_derivatives_(options.curvature_derivatives) {}

    /// Optional columns only if the options asked for them.
    Field field() const {
        const std::lock_guard using_parts(parts_);
        Field field = field_;
        if (!wants_derivatives_) {
            field.smooth_curvatures.clear();
            field.curvature_derivatives.clear();
        }
        return field;
    }
    const FieldScale& scale() const { return field_.scale; }
    const MeshReport& report() const { return field_.report; }

    /// All lines of a view as LineExtractor::extract(), none of them marked as hidden or an
    /// outline.
    std::vector<ViewLine> lines(const View& view, const LineStyle& style,
                                const Progress& progress) {
        const std::lock_guard using_parts(parts_);
        ExtractionScratch scratch;
        LineSet set;
        extractor(style, progress).extract(view, style, scratch, set);
        std::vector<ViewLine> lines;
        for (const Polyline& line : set.lines) {
            ViewLine& found = lines.emplace_back();
            found.kind = line.kind;
            found.closed = line.closed;
            found.strength = line.strength;
            for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
                const LinePoint& point = set.points[i];
                found.points.push_back(
                    {set.position(point), point.weight, point.gradient, point.opacity, 0, false});
            }
        }
        return lines;
    }

    /// The visible lines, and the hidden ones if asked for, see LineVisibility::visible_lines().
    /// The style has the kinds and the smoothing.
    std::vector<ViewLine> visible_lines(const View& view, const LineStyle& style,
                                        VisibilityOptions options, const Progress& progress) {
        const std::lock_guard using_parts(parts_);
        if (!visibility_) visibility_ = std::make_unique<LineVisibility>(mesh_, progress);
        ExtractionScratch scratch;
        const LineSet lines = extract_on_surface(extractor(style, progress), view, style, scratch);
        options.shows = style.shows;
        options.line_smoothing = style.line_smoothing;
        options.shortest_contour = style.shortest_contour;
        return visibility_->visible_lines(view, {lines}, options, progress);
    }

    /// See line_drawing::strokes_of(); with the field's kernel if the options have one.
    std::vector<ViewLine> strokes(const line_drawing::ViewFrame& frame,
                                  const line_drawing::SheetOptions& options, double size,
                                  const Progress& progress) {
        const std::lock_guard using_parts(parts_);
        if (has_own_kernel_ && options.style.shows.needs_derivatives())
            extractor(options.style, progress);  // adds them to the field
        const line_drawing::Objects objects = {{mesh_, has_own_kernel_ ? &field_ : nullptr}};
        return line_drawing::strokes_of(objects, frame, options, progress, size);
    }

private:
    /// With derivatives if the style needs them.
    const LineExtractor& extractor(const LineStyle& style, const Progress& progress) {
        if (!extractor_) extractor_ = std::make_unique<LineExtractor>(mesh_, field_, progress);
        if (style.shows.needs_derivatives() && !field_.has_derivatives()) {
            Field field = field_;  // as a whole or not at all
            add_curvature_derivatives(mesh_, field, progress);
            extractor_->add_derivatives(mesh_, field);
            field_ = std::move(field);
        }
        return *extractor_;
    }

    const TriangleMesh mesh_;
    Field field_;
    const bool has_own_kernel_;
    const bool wants_derivatives_;
    std::unique_ptr<LineExtractor> extractor_;
    std::unique_ptr<const LineVisibility> visibility_;
    mutable std::mutex parts_;  // one view at a time, which the core computes on all processors
};

}  // namespace python_module
