// SPDX-License-Identifier: GPL-3.0-or-later
#include "observer.h"

#include <algorithm>

#include "cutting.h"
#include "half_section.h"
#include "place_on_axis.h"
#include "progress_part.h"
#include "section_marks.h"
#include "words.h"

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

std::vector<laplacian_lines::LineExtractor> extractorsOf(const Objects& objects,
                                                         const Progress& progress) {
    const auto count = double(objects.size());
    std::vector<laplacian_lines::LineExtractor> extractors;
    for (const Object& object : objects) {
        const auto done = double(extractors.size());
        extractors.emplace_back(object.mesh, object.field,
                                part(progress, done / count, (done + 1) / count));
    }
    return extractors;
}

std::vector<laplacian_lines::LineSet> clipEach(std::vector<laplacian_lines::LineSet> lines,
                                               const HalfSpace& inside) {
    for (laplacian_lines::LineSet& set : lines)
        set = clip(set, inside);
    return lines;
}

}  // namespace

Observer::Observer(const Objects& objects, const Progress& progress)
    : objects_(objects),
      surface_(objects),
      box_(boundsOf(surface_.mesh())),
      extractors_(extractorsOf(objects, part(progress, 0, 0.75))),
      visibility_(surface_.mesh(), fieldsOf(objects), part(progress, 0.75, 1)) {}

DrawnView Observer::stand(const ViewFrame& frame, const SheetOptions& options) const {
    const double unit = options.mm_per_unit;
    const Eigen::AlignedBox2d bounds = Projection(frame, box_.center()).boundsOf(surface_.mesh());
    if (frame.eye && bounds.isEmpty())
        refuse("All of the object is behind the eye of a view in perspective.");
    return {frame, {unit * bounds.min(), unit * bounds.max()},
            {},    false,
            {},    marksOf(frame, options, box_)};
}

void Observer::look(DrawnView& drawn, const SheetOptions& options, const Progress& progress) {
    laplacian_lines::View view = Projection(drawn.frame, box_.center()).view();
    if (drawn.frame.eye && visibility_.encloses(*drawn.frame.eye))
        refuse(
            "The eye of a view in perspective is inside the surface. Move it outside, or take a "
            "view without perspective.");
    if (options.light) view.light = inMesh(*options.light, drawn.frame);
    std::vector<laplacian_lines::LineSet> lines(objects_.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
        extractors_[i].extract(view, options.style, scratch_, lines[i]);
    if (drawn.frame.is_half_section) return lookHalf(drawn, view, lines, options, progress);
    drawn.lines = draw(visibility_.parts(view, lines, progress), drawn.frame, options);
}

std::vector<DrawnLine> Observer::draw(const laplacian_lines::LineParts& parts,
                                      const ViewFrame& frame, const SheetOptions& options) const {
    const Projection projection(frame, box_.center());
    const auto project_lines = [&](const laplacian_lines::LineSet& lines) {
        return project(projection.inSight(lines), projection, options.mm_per_unit);
    };
    std::vector<DrawnLine> drawn = project_lines(parts.seen);
    if (options.hidden == HiddenLines::LeftOut) return drawn;
    for (DrawnLine& line : project_lines(edgesOf(parts.hidden))) {
        line.line_class = LineClass::Hidden;
        for (DrawnPoint& point : line.points)
            point.weight = 1;
        drawn.push_back(std::move(line));
    }
    return drawn;
}

void Observer::lookHalf(DrawnView& drawn, const laplacian_lines::View& view,
                        const std::vector<laplacian_lines::LineSet>& lines,
                        const SheetOptions& options, const Progress& progress) const {
    const HalfSection half(objects_, surface_.mesh(), drawn.frame);
    const TriangleMesh rest = clip(surface_.mesh(), half.behind());
    const laplacian_lines::LineVisibility visibility(rest, fieldsOf(objects_),
                                                     part(progress, 0, 0.3));
    const auto inside = clipEach(clipEach(lines, half.behind()), half.left());
    drawn.lines =
        draw(visibility.parts(view, inside, part(progress, 0.3, 0.6)), drawn.frame, options);
    for (DrawnLine& line : drawn.lines)  // the outline of this half is the section's
        line.line_class = std::max(line.line_class, LineClass::Inner);
    half.draw(drawn, box_.center(), options.mm_per_unit);
    const laplacian_lines::LineParts all = visibility_.parts(view, lines, part(progress, 0.6, 1));
    const std::vector<DrawnLine> outside =
        draw({clip(all.seen, half.right()), clip(all.hidden, half.right())}, drawn.frame, options);
    drawn.lines.insert(drawn.lines.end(), outside.begin(), outside.end());
}

DrawnView Observer::cut(const Section& section, const SheetOptions& options) const {
    DrawnView drawn = stand(frameOfSection(section, options.up), options);
    drawn.is_section = true;
    drawn.marks.clear();
    const Projection projection(drawn.frame, box_.center());
    for (const Object& object : objects_) {
        Wall& wall = drawn.walls.emplace_back();
        for (const Cut& cut : cutMesh(object.mesh, section.axis, placeOnAxis(section, box_))) {
            drawn.lines.push_back(project(cut, projection, options.mm_per_unit));
            if (drawn.lines.back().closed) wall.push_back(positionsOf(drawn.lines.back()));
        }
    }
    return drawn;
}

}  // namespace line_drawing
