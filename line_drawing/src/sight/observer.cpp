// SPDX-License-Identifier: GPL-3.0-or-later
#include "sight/observer.h"

#include <algorithm>

#include "laplacian_lines/error.h"
#include "line_drawing/words.h"
#include "options/progress_part.h"
#include "planes/cutting.h"
#include "sections/half_section.h"
#include "sections/section_marks.h"
#include "sections/wall_area.h"

namespace line_drawing {

using laplacian_lines::Progress;
using laplacian_lines::TriangleMesh;

namespace {

std::vector<laplacian_lines::LineSet> clipEach(std::vector<laplacian_lines::LineSet> lines,
                                               const HalfSpace& inside) {
    for (laplacian_lines::LineSet& set : lines)
        set = clip(set, inside);
    return lines;
}

laplacian_lines::SightOptions sightOf(const SheetOptions& options) {
    return {options.style.shows, options.style.line_smoothing,
            options.hidden != HiddenLines::LeftOut, true};
}

TriangleMesh joinedMesh(const Objects& objects) {
    TriangleMesh all;
    for (const Object& object : objects) {
        const auto first = std::uint32_t(all.positions.size());
        all.positions.insert(all.positions.end(), object.mesh.positions.begin(),
                             object.mesh.positions.end());
        for (const laplacian_lines::Triangle& t : object.mesh.triangles)
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    return all;
}

}  // namespace

Observer::Observer(const Objects& objects)
    : objects_(objects),
      joined_(objects.size() == 1 ? TriangleMesh() : joinedMesh(objects)),
      surface_(objects.size() == 1 ? objects.front().mesh : joined_),
      box_(boundsOf(surface_)) {
    for (const laplacian_lines::Triangle& t : surface_.triangles)
        for (const std::uint32_t v : t)
            if (v >= surface_.positions.size())
                throw laplacian_lines::Error(laplacian_lines::ErrorCode::InvalidMesh,
                                             "A triangle names a vertex that is not there.");
}

void Observer::prepareCuts() {
    if (cuttable_.empty())
        for (const Object& object : objects_)
            cuttable_.emplace_back(object.mesh);
}

DrawnView Observer::stand(const ViewFrame& frame, const SheetOptions& options) {
    if (frame.is_half_section) prepareCuts();
    const double unit = options.mm_per_unit;
    const Eigen::AlignedBox2d flat = Projection(frame, box_.center()).boundsOf(surface_);
    if (frame.eye && flat.isEmpty())
        refuse("All of the object is behind the eye of a view in perspective.");
    DrawnView drawn{frame, {unit * flat.min(), unit * flat.max()}};
    drawn.marks = marksOf(frame, options, box_);
    return drawn;
}

void Observer::prepare(const std::vector<SheetOptions>& sheets, const Progress& progress) {
    visibility_.emplace(surface_, progress);
    const bool are_alone = std::any_of(sheets.begin(), sheets.end(), [](const SheetOptions& o) {
        return o.area == OutlineArea::Objects;
    });
    for (std::size_t i = 0; are_alone && i < objects_.size(); ++i)
        alone_.emplace_back(objects_[i].mesh);
}

laplacian_lines::View Observer::viewOf(const DrawnView& drawn, const SheetOptions& options) const {
    laplacian_lines::View view = Projection(drawn.frame, box_.center()).view();
    if (options.light) view.light = inMesh(*options.light, drawn.frame);
    return view;
}

std::vector<laplacian_lines::LineSet> Observer::linesOf(const DrawnView& drawn,
                                                        const SheetOptions& options,
                                                        ObjectLines& lines) const {
    return lines.extract(viewOf(drawn, options), options.style);
}

void Observer::look(DrawnView& drawn, const std::vector<laplacian_lines::LineSet>& lines,
                    const SheetOptions& options, const Progress& progress) const {
    if (drawn.frame.eye && visibility_->encloses(*drawn.frame.eye))
        refuse(
            "The eye of a view in perspective is inside the surface. Move it outside, or take a "
            "view without perspective.");
    const laplacian_lines::View view = viewOf(drawn, options);
    if (drawn.frame.is_half_section) return lookHalf(drawn, view, lines, options, progress);
    drawn.lines =
        draw(visibility_->look(view, lines, sightOf(options), progress), drawn.frame, options);
    if (options.area == OutlineArea::Objects) addSilhouettes(drawn, options);
}

void Observer::addSilhouettes(DrawnView& drawn, const SheetOptions& options) const {
    laplacian_lines::SightOptions outlines = sightOf(options);
    outlines.has_hidden = false;
    outlines.shows = {};
    outlines.shows[laplacian_lines::LineKind::Contour] = true;
    outlines.shows[laplacian_lines::LineKind::Border] = true;
    const laplacian_lines::View view = Projection(drawn.frame, box_.center()).view();
    for (const laplacian_lines::LineVisibility& alone : alone_)
        drawn.silhouettes.push_back(draw(alone.look(view, {}, outlines), drawn.frame, options));
}

std::vector<DrawnLine> Observer::draw(const SightLines& lines, const ViewFrame& frame,
                                      const SheetOptions& options) const {
    const Projection projection(frame, box_.center());
    return project(projection.inSight(lines), projection, options.mm_per_unit);
}

void Observer::lookHalf(DrawnView& drawn, const laplacian_lines::View& view,
                        const std::vector<laplacian_lines::LineSet>& lines,
                        const SheetOptions& options, const Progress& progress) const {
    const HalfSection half(surface_, drawn.frame);
    half.expectVessel();
    drawn.note = half.words();
    const laplacian_lines::LineVisibility visibility(clip(surface_, half.behind()),
                                                     part(progress, 0, 0.3));
    const SightLines inside = visibility.look(view, clipEach(lines, half.behind()),
                                              sightOf(options), part(progress, 0.3, 0.6));
    drawn.lines = draw(clip(inside, half.left()), drawn.frame, options);
    for (DrawnLine& line : drawn.lines)  // the outline of this half is the section's
        if (line.line_class == LineClass::Outline) line.line_class = LineClass::Contour;
    half.draw(drawn, cuttable_, box_.center(), options.mm_per_unit);
    const SightLines all = visibility_->look(view, lines, sightOf(options), part(progress, 0.6, 1));
    const std::vector<DrawnLine> outside = draw(clip(all, half.right()), drawn.frame, options);
    drawn.lines.insert(drawn.lines.end(), outside.begin(), outside.end());
}

double Observer::checkOutlines(DrawnView& drawn, const SheetOptions& options, double pixel) const {
    // In perspective, some of the surface may be out of the picture or behind the eye.
    const auto& shows = options.style.shows;
    if (drawn.frame.is_half_section || drawn.frame.eye ||
        !shows[laplacian_lines::LineKind::Contour] || !shows[laplacian_lines::LineKind::Border])
        return 0;
    const Projection projection(drawn.frame, box_.center());
    const auto missing = borderWithoutOutline(surface_, projection, options.mm_per_unit,
                                              drawn.bounds, drawn.lines, pixel);
    if (missing.empty()) return 0;
    laplacian_lines::SightOptions all = sightOf(options);
    all.has_hidden = true;
    const SightLines edges = visibility_->look(projection.view(), {}, all);
    for (DrawnLine& line : linesAt(missing, draw(edges, drawn.frame, options), pixel))
        drawn.lines.push_back(std::move(line));
    return pixel * double(missing.size());
}

DrawnView Observer::cut(const Section& section, const SheetOptions& options) {
    prepareCuts();
    DrawnView drawn = stand(frameOfSection(section, options.up), options);
    drawn.is_section = true;
    drawn.marks.clear();
    const Projection projection(drawn.frame, box_.center());
    std::vector<CutObject> objects;
    for (const CuttableMesh& object : cuttable_) {
        CutObject parts;
        for (const Cut& cut : object.cut(section.axis, placeOnAxis(section, box_))) {
            parts.lines.push_back(project(cut, projection, options.mm_per_unit));
            if (parts.lines.back().closed) parts.wall.push_back(positionsOf(parts.lines.back()));
        }
        objects.push_back(std::move(parts));
    }
    addWalls(objects, drawn);
    return drawn;
}

}  // namespace line_drawing
