// SPDX-License-Identifier: GPL-3.0-or-later
#include "observer.h"

#include <algorithm>

#include "cutting.h"
#include "half_section.h"
#include "place_on_axis.h"
#include "progress_part.h"
#include "section_marks.h"

namespace line_drawing {

using laplacian_lines::Progress;
using laplacian_lines::TriangleMesh;

namespace {

/// Without the lines that show what the surface is like: hidden ones would only confuse.
laplacian_lines::LineSet edgesOf(laplacian_lines::LineSet lines) {
    auto& all = lines.lines;
    const auto is_inner = [](const laplacian_lines::Polyline& line) {
        return !laplacian_lines::describe(line.kind).is_outline &&
               line.kind != laplacian_lines::LineKind::Crease;
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_inner), all.end());
    return lines;
}

}  // namespace

Observer::Observer(const TriangleMesh& mesh, const laplacian_lines::Field& field,
                   const Progress& progress)
    : mesh_(mesh),
      field_(field),
      box_(boundsOf(mesh)),
      extractor_(mesh, field, part(progress, 0, 0.75)),
      visibility_(mesh, field, part(progress, 0.75, 1)) {}

DrawnView Observer::stand(const ViewFrame& frame, const SheetOptions& options) const {
    const double unit = options.mm_per_unit;
    const Eigen::AlignedBox2d bounds = boundsOf(mesh_, frame, box_.center());
    return {frame, {unit * bounds.min(), unit * bounds.max()},
            {},    false,
            {},    marksOf(frame, options, box_)};
}

void Observer::look(DrawnView& drawn, const SheetOptions& options, const Progress& progress) {
    auto view = laplacian_lines::View::orthographic(drawn.frame.towards_viewer);
    if (options.light) view.light = inMesh(*options.light, drawn.frame);
    laplacian_lines::LineSet lines;
    extractor_.extract(view, options.style, scratch_, lines);
    if (drawn.frame.is_half_section) return lookHalf(drawn, view, lines, options, progress);
    const laplacian_lines::LineParts parts = visibility_.parts(view, lines, progress);
    drawn.lines = project(parts.seen, drawn.frame, box_.center(), options.mm_per_unit);
    if (options.hidden == HiddenLines::LeftOut) return;
    for (DrawnLine& line :
         project(edgesOf(parts.hidden), drawn.frame, box_.center(), options.mm_per_unit)) {
        line.line_class = LineClass::Hidden;
        for (DrawnPoint& point : line.points)
            point.weight = 1;
        drawn.lines.push_back(std::move(line));
    }
}

void Observer::lookHalf(DrawnView& drawn, const laplacian_lines::View& view,
                        const laplacian_lines::LineSet& lines, const SheetOptions& options,
                        const Progress& progress) const {
    const HalfSection half(mesh_, drawn.frame);
    const auto project_lines = [&](const laplacian_lines::LineSet& seen) {
        return project(seen, drawn.frame, box_.center(), options.mm_per_unit);
    };
    const TriangleMesh rest = clip(mesh_, half.behind());
    const laplacian_lines::LineVisibility visibility(rest, field_, part(progress, 0, 0.3));
    drawn.lines = project_lines(visibility.visible_parts(
        view, clip(clip(lines, half.behind()), half.left()), part(progress, 0.3, 0.6)));
    for (DrawnLine& line : drawn.lines)  // the outline of this half is the section's
        line.line_class = std::max(line.line_class, LineClass::Inner);
    half.draw(drawn, box_.center(), options.mm_per_unit);
    const std::vector<DrawnLine> outside = project_lines(
        clip(visibility_.visible_parts(view, lines, part(progress, 0.6, 1)), half.right()));
    drawn.lines.insert(drawn.lines.end(), outside.begin(), outside.end());
}

DrawnView Observer::cut(const Section& section, const SheetOptions& options) const {
    DrawnView drawn = stand(frameOfSection(section, options.up), options);
    drawn.is_section = true;
    drawn.marks.clear();
    for (const Cut& cut : cutMesh(mesh_, section.axis, placeOnAxis(section, box_))) {
        drawn.lines.push_back(project(cut, drawn.frame, box_.center(), options.mm_per_unit));
        if (drawn.lines.back().closed) drawn.walls.push_back(positionsOf(drawn.lines.back()));
    }
    return drawn;
}

}  // namespace line_drawing
