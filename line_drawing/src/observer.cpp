// SPDX-License-Identifier: GPL-3.0-or-later
#include "observer.h"

#include "cutting.h"
#include "progress_part.h"

namespace line_drawing {

using laplacian_lines::Progress;
using laplacian_lines::TriangleMesh;

Observer::Observer(const TriangleMesh& mesh, const laplacian_lines::Field& field,
                   const Progress& progress)
    : mesh_(mesh),
      box_(boundsOf(mesh)),
      extractor_(mesh, field, part(progress, 0, 0.75)),
      visibility_(mesh, field, part(progress, 0.75, 1)) {}

DrawnView Observer::stand(const ViewFrame& frame, const SheetOptions& options) const {
    const double unit = options.mm_per_unit;
    const Eigen::AlignedBox2d bounds = boundsOf(mesh_, frame, box_.center());
    return {frame, {unit * bounds.min(), unit * bounds.max()}, {}};
}

void Observer::look(DrawnView& drawn, const SheetOptions& options, const Progress& progress) {
    const auto view = laplacian_lines::View::orthographic(drawn.frame.towards_viewer);
    laplacian_lines::LineSet lines;
    extractor_.extract(view, options.style, scratch_, lines);
    lines = visibility_.visible_parts(view, lines, progress);
    drawn.lines = project(lines, drawn.frame, box_.center(), options.mm_per_unit);
}

DrawnView Observer::cut(const Section& section, const SheetOptions& options) const {
    DrawnView drawn = stand(frameOfSection(section, options.up), options);
    const double height = box_.min()[section.axis] + section.share * box_.sizes()[section.axis];
    for (const Cut& cut : cutMesh(mesh_, section.axis, height))
        drawn.lines.push_back(project(cut, drawn.frame, box_.center(), options.mm_per_unit));
    return drawn;
}

}  // namespace line_drawing
