// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface.h"

#include <utility>

#include "laplacian_lines/refinement.h"

namespace python_module {
namespace {

/// A line without what only LineVisibility knows.
ViewLine view_line(const LineSet& set, const Polyline& line) {
    ViewLine result{};  // neither hidden nor an outline
    result.kind = line.kind;
    result.closed = line.closed;
    result.strength = line.strength;
    for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
        const LinePoint& point = set.points[i];
        result.points.push_back(
            {set.position(point), point.weight, point.gradient, point.opacity, kNoNode, false});
    }
    return result;
}

}  // namespace

Surface::Surface(TriangleMesh mesh, const PrecomputeOptions& options, const Progress& progress)
    : mesh_(std::move(mesh)),
      options_(options),
      field_(precompute(mesh_, options, progress)),
      may_be_refined_(options.weld_duplicates) {}

Field Surface::field() const {
    const std::lock_guard using_parts(parts_);
    Field field = field_;
    if (!options_.curvature_derivatives) {
        field.smooth_curvatures.clear();
        field.curvature_derivatives.clear();
    }
    return field;
}

std::vector<ViewLine> Surface::lines(const View& view, const LineStyle& style,
                                     const Progress& progress) {
    const std::lock_guard using_parts(parts_);
    ExtractionScratch scratch;
    LineSet set;
    extractor(style, progress).extract(view, style, scratch, set);
    std::vector<ViewLine> lines;
    for (const Polyline& line : set.lines)
        lines.push_back(view_line(set, line));
    return lines;
}

std::vector<ViewLine> Surface::visible_lines(const View& view, const LineStyle& style,
                                             VisibilityOptions options, const Progress& progress) {
    const std::lock_guard using_parts(parts_);
    if (!visibility_)
        visibility_ = std::make_unique<LineVisibility>(drawn_mesh(progress), progress);
    ExtractionScratch scratch;
    const LineSet lines = extract_on_surface(extractor(style, progress), view, style, scratch);
    options.shows = style.shows;
    options.line_smoothing = style.line_smoothing;
    options.shortest_contour = style.shortest_contour;
    return visibility_->visible_lines(view, {lines}, options, progress);
}

std::vector<ViewLine> Surface::strokes(const line_drawing::ViewFrame& frame,
                                       const line_drawing::SheetOptions& options, double size,
                                       const Progress& progress) {
    const std::lock_guard using_parts(parts_);
    const bool has_own_kernel = options_.kernel_size > 0;
    if (has_own_kernel && options.style.shows.needs_derivatives())
        extractor(options.style, progress);  // adds them to the field
    const line_drawing::Objects objects = {
        {drawn_mesh(progress), has_own_kernel ? &drawn_field(progress) : nullptr}};
    return line_drawing::strokes_of(objects, frame, options, progress, size);
}

const TriangleMesh& Surface::drawn_mesh(const Progress& progress) {
    if (may_be_refined_) {
        TriangleMesh finer = refined(mesh_, progress);
        may_be_refined_ = false;
        // undone and cut finer again, a subdivided mesh may have as many triangles as before
        const bool is_other = finer.triangles.size() != mesh_.triangles.size();
        if (finer.known_edge > 0 || is_other) finer_ = std::move(finer);
    }
    return finer_ ? *finer_ : mesh_;
}

Field& Surface::drawn_field(const Progress& progress) {
    const TriangleMesh& drawn = drawn_mesh(progress);
    if (!finer_) return field_;
    if (!finer_field_) finer_field_ = precompute(drawn, options_, progress);
    return *finer_field_;
}

/// With derivatives if the style needs them.
const LineExtractor& Surface::extractor(const LineStyle& style, const Progress& progress) {
    const TriangleMesh& drawn = drawn_mesh(progress);
    Field& known = drawn_field(progress);
    if (!extractor_) extractor_ = std::make_unique<LineExtractor>(drawn, known, progress);
    if (style.shows.needs_derivatives() && !known.has_derivatives()) {
        Field field = known;  // as a whole or not at all
        add_curvature_derivatives(drawn, field, progress);
        extractor_->add_derivatives(drawn, field);
        known.smooth_curvatures = std::move(field.smooth_curvatures);  // the rest is read unlocked
        known.curvature_derivatives = std::move(field.curvature_derivatives);
    }
    return *extractor_;
}

}  // namespace python_module
