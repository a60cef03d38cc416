// SPDX-License-Identifier: GPL-3.0-or-later
#include "sight/view_builder.h"

#include <algorithm>
#include <cmath>

#include "laplacian_lines/error.h"
#include "line_drawing/words.h"
#include "planes/clipping.h"
#include "sections/half_section.h"
#include "sections/section_marks.h"
#include "sections/wall_area.h"

namespace line_drawing {

using Eigen::Vector2d;
using laplacian_lines::part;
using laplacian_lines::Progress;
using laplacian_lines::TriangleMesh;

namespace {

laplacian_lines::VisibilityOptions visibility_options(const SheetOptions& options) {
    return {options.style.shows, options.style.line_smoothing,
            options.hidden != HiddenLines::LeftOut, true};
}

TriangleMesh joined_mesh(const Objects& objects) {
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

constexpr double kMostPixels = 4096;  // along a side
constexpr int kReach = 2;             // pixels, within which an outline counts as there

/// Pixels of a box, with room for outlines around it.
class Mask {
public:
    Mask(const Eigen::AlignedBox2d& box, double pixel)
        : pixel_(pixel),
          low_(box.min() - Vector2d::Constant((kReach + 1) * pixel_)),
          width_(std::size_t(std::ceil(box.sizes().x() / pixel_)) + 2 * kReach + 3),
          height_(std::size_t(std::ceil(box.sizes().y() / pixel_)) + 2 * kReach + 3),
          is_set_(width_ * height_) {}

    Vector2d in_pixels(const Vector2d& p) const { return (p - low_) / pixel_; }
    Vector2d middle_of(std::size_t x, std::size_t y) const {
        return low_ + pixel_ * Vector2d(double(x) + 0.5, double(y) + 0.5);
    }
    std::size_t width() const { return width_; }
    std::size_t height() const { return height_; }
    bool is_set(std::size_t x, std::size_t y) const { return is_set_[y * width_ + x] != 0; }

    void clear() { std::fill(is_set_.begin(), is_set_.end(), 0); }

    void fill(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
        const double low = std::min({a.y(), b.y(), c.y()}), high = std::max({a.y(), b.y(), c.y()});
        for (double y = std::ceil(low - 0.5); y + 0.5 <= high; ++y) {
            double begin = INFINITY, end = -INFINITY;
            for (const auto& [from, to] :
                 {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
                if ((from->y() <= y + 0.5) == (to->y() <= y + 0.5)) continue;
                const double t = (y + 0.5 - from->y()) / (to->y() - from->y());
                const double x = from->x() + t * (to->x() - from->x());
                begin = std::min(begin, x);
                end = std::max(end, x);
            }
            for (double x = std::max(0., std::ceil(begin - 0.5)); x + 0.5 <= end; ++x)
                set(x, y);
        }
    }

    void draw(const Vector2d& from, const Vector2d& to) {
        const double steps = std::max(1., std::ceil((to - from).norm()));
        for (double i = 0; i <= steps; ++i) {
            const Vector2d p = from + i / steps * (to - from);
            for (int dy = -kReach; dy <= kReach; ++dy)
                for (int dx = -kReach; dx <= kReach; ++dx)
                    set(std::floor(p.x()) + dx, std::floor(p.y()) + dy);
        }
    }

private:
    void set(double x, double y) {
        if (x >= 0 && y >= 0 && x < double(width_) && y < double(height_))
            is_set_[std::size_t(y) * width_ + std::size_t(x)] = 1;
    }

    const double pixel_;
    const Vector2d low_;
    const std::size_t width_, height_;
    std::vector<char> is_set_;
};

Mask cover_of(const TriangleMesh& mesh, const Projection& projection, double unit,
              const Eigen::AlignedBox2d& bounds, double pixel) {
    Mask cover(bounds.isEmpty() ? Eigen::AlignedBox2d(Vector2d(0, 0)) : bounds, pixel);
    std::vector<Vector2d> places;  // in pixels; not finite where vertices are not
    places.reserve(mesh.positions.size());
    for (const Eigen::Vector3d& p : mesh.positions)
        places.push_back(cover.in_pixels(unit * projection(p)));
    for (const laplacian_lines::Triangle& t : mesh.triangles) {
        const Vector2d &a = places[t[0]], &b = places[t[1]], &c = places[t[2]];
        if (std::isfinite(a.sum() + b.sum() + c.sum())) cover.fill(a, b, c);
    }
    return cover;
}

bool is_at_border(const Mask& cover, std::size_t x, std::size_t y) {
    return cover.is_set(x, y) && (!cover.is_set(x - 1, y) || !cover.is_set(x + 1, y) ||
                                  !cover.is_set(x, y - 1) || !cover.is_set(x, y + 1));
}

/// Checks a view's outlines independently: fills its triangles in pixels of this size, mm of the
/// object. Returns the centres of border pixels without an outline within two pixels. `bounds` are
/// the surface's in the view.
std::vector<Vector2d> border_without_outline(const TriangleMesh& mesh, const Projection& projection,
                                             double unit, const Eigen::AlignedBox2d& bounds,
                                             const std::vector<DrawnLine>& lines, double pixel) {
    const Mask cover = cover_of(mesh, projection, unit, bounds, pixel);
    Mask outlines = cover;
    outlines.clear();
    for (const DrawnLine& line : lines)
        if (line.line_class == LineClass::Outline)
            for (std::size_t i = 1; i < line.points.size(); ++i)
                outlines.draw(outlines.in_pixels(line.points[i - 1].position),
                              outlines.in_pixels(line.points[i].position));
    std::vector<Vector2d> missing;
    for (std::size_t y = 1; y + 1 < cover.height(); ++y)
        for (std::size_t x = 1; x + 1 < cover.width(); ++x)
            if (is_at_border(cover, x, y) && !outlines.is_set(x, y))
                missing.push_back(cover.middle_of(x, y));
    return missing;
}

/// Segments within three pixels of these points, as outlines.
std::vector<DrawnLine> lines_at(const std::vector<Vector2d>& places,
                                const std::vector<DrawnLine>& lines, double pixel) {
    std::vector<DrawnLine> found;
    for (const DrawnLine& line : lines)
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const Vector2d &a = line.points[i - 1].position, &b = line.points[i].position;
            const double squared = (b - a).squaredNorm();
            const auto is_near = [&](const Vector2d& p) {
                const double t = squared > 0 ? std::clamp((b - a).dot(p - a) / squared, 0., 1.) : 0;
                return (a + t * (b - a) - p).norm() <= (kReach + 1) * pixel;
            };
            if (std::any_of(places.begin(), places.end(), is_near))
                found.push_back({LineClass::Outline, false, {{a}, {b}}});
        }
    return found;
}

}  // namespace

ViewBuilder::ViewBuilder(const Objects& objects)
    : objects_(objects),
      joined_(objects.size() == 1 ? TriangleMesh() : joined_mesh(objects)),
      surface_(objects.size() == 1 ? objects.front().mesh : joined_),
      box_(bounds_of(objects)) {
    for (const Object& object : objects)  // in joined_ it could be a vertex of the next object
        for (const laplacian_lines::Triangle& t : object.mesh.triangles)
            for (const std::uint32_t v : t)
                if (v >= object.mesh.positions.size())
                    throw laplacian_lines::Error(laplacian_lines::ErrorCode::InvalidMesh,
                                                 "A triangle names a vertex that is not there.");
}

void ViewBuilder::prepare_cuts() {
    if (cuttable_.empty())
        for (const Object& object : objects_)
            cuttable_.emplace_back(object.mesh);
}

DrawnView ViewBuilder::empty_view(const ViewFrame& frame, const SheetOptions& options) {
    if (frame.is_half_section) prepare_cuts();
    const double unit = options.mm_per_unit;
    const Eigen::AlignedBox2d flat = Projection(frame, box_.center()).bounds_of(surface_);
    if (frame.eye && flat.isEmpty())
        refuse("All of the object is behind the eye of a view in perspective.");
    DrawnView drawn{frame, {unit * flat.min(), unit * flat.max()}};
    drawn.marks = marks_of(frame, options, box_);
    return drawn;
}

void ViewBuilder::prepare(const std::vector<SheetOptions>& sheets, const Progress& progress) {
    visibility_.emplace(surface_, progress);
    const bool are_alone = std::any_of(sheets.begin(), sheets.end(), [](const SheetOptions& o) {
        return o.area == OutlineArea::Objects;
    });
    for (std::size_t i = 0; are_alone && i < objects_.size(); ++i)
        alone_.emplace_back(objects_[i].mesh);
}

laplacian_lines::View ViewBuilder::view_of(const DrawnView& drawn,
                                           const SheetOptions& options) const {
    laplacian_lines::View view = Projection(drawn.frame, box_.center()).view();
    if (options.light) view.light = in_mesh(*options.light, drawn.frame);
    return view;
}

void ViewBuilder::add_lines(DrawnView& drawn, const std::vector<laplacian_lines::LineSet>& lines,
                            const SheetOptions& options, const Progress& progress) const {
    if (drawn.frame.eye && visibility_->encloses(*drawn.frame.eye))
        refuse(
            "The eye of a view in perspective is inside the surface. Move it outside, or take a "
            "view without perspective.");
    const laplacian_lines::View view = view_of(drawn, options);
    if (drawn.frame.is_half_section)
        return add_half_section_lines(drawn, view, lines, options, progress);
    drawn.lines =
        draw(visibility_->visible_lines(view, lines, visibility_options(options), progress),
             drawn.frame, options);
    if (options.area == OutlineArea::Objects) add_silhouettes(drawn, options);
}

void ViewBuilder::add_silhouettes(DrawnView& drawn, const SheetOptions& options) const {
    laplacian_lines::VisibilityOptions outlines = visibility_options(options);
    outlines.has_hidden = false;
    outlines.shows = {};
    outlines.shows[laplacian_lines::LineKind::Contour] = true;
    outlines.shows[laplacian_lines::LineKind::Border] = true;
    const laplacian_lines::View view = Projection(drawn.frame, box_.center()).view();
    for (const laplacian_lines::LineVisibility& alone : alone_)
        drawn.silhouettes.push_back(
            draw(alone.visible_lines(view, {}, outlines), drawn.frame, options));
}

std::vector<DrawnLine> ViewBuilder::draw(const ViewLines& lines, const ViewFrame& frame,
                                         const SheetOptions& options) const {
    const Projection projection(frame, box_.center());
    return project(projection.clip_to_view(lines), projection, options.mm_per_unit);
}

void ViewBuilder::add_half_section_lines(DrawnView& drawn, const laplacian_lines::View& view,
                                         const std::vector<laplacian_lines::LineSet>& lines,
                                         const SheetOptions& options,
                                         const Progress& progress) const {
    const HalfSection half(surface_, drawn.frame);
    half.expect_vessel();
    drawn.note = half.words();
    const laplacian_lines::LineVisibility visibility(clip(surface_, half.behind()),
                                                     part(progress, 0, 0.3));
    std::vector<laplacian_lines::LineSet> behind;
    for (const laplacian_lines::LineSet& set : lines)
        behind.push_back(clip(set, half.behind()));
    const ViewLines inside = visibility.visible_lines(view, behind, visibility_options(options),
                                                      part(progress, 0.3, 0.6));
    drawn.lines = draw(clip(inside, half.left()), drawn.frame, options);
    for (DrawnLine& line : drawn.lines)  // the section has the outline of this half
        if (line.line_class == LineClass::Outline) line.line_class = LineClass::Contour;
    half.draw(drawn, cuttable_, box_.center(), options.mm_per_unit);
    const ViewLines all = visibility_->visible_lines(view, lines, visibility_options(options),
                                                     part(progress, 0.6, 1));
    laplacian_lines::append_with_own_nodes(draw(clip(all, half.right()), drawn.frame, options),
                                           drawn.lines);
}

double ViewBuilder::check_outlines(DrawnView& drawn, const SheetOptions& options,
                                   double pixel) const {
    // In perspective, part of the surface may be outside the picture or behind the eye.
    const auto& shows = options.style.shows;
    if (drawn.frame.is_half_section || drawn.frame.eye ||
        !shows[laplacian_lines::LineKind::Contour] || !shows[laplacian_lines::LineKind::Border])
        return 0;
    pixel = std::max(pixel, drawn.bounds.sizes().maxCoeff() / kMostPixels);
    const Projection projection(drawn.frame, box_.center());
    const auto missing = border_without_outline(surface_, projection, options.mm_per_unit,
                                                drawn.bounds, drawn.lines, pixel);
    if (missing.empty()) return 0;
    laplacian_lines::VisibilityOptions all = visibility_options(options);
    all.has_hidden = true;
    const ViewLines edges = visibility_->visible_lines(projection.view(), {}, all);
    for (DrawnLine& line : lines_at(missing, draw(edges, drawn.frame, options), pixel))
        drawn.lines.push_back(std::move(line));
    return pixel * double(missing.size());
}

DrawnView ViewBuilder::section_view(const Section& section, const SheetOptions& options) {
    prepare_cuts();
    DrawnView drawn = empty_view(frame_of_section(section, options.up), options);
    drawn.is_section = true;
    drawn.marks.clear();
    const Projection projection(drawn.frame, box_.center());
    std::vector<CutObject> objects;
    for (const CuttableMesh& object : cuttable_) {
        CutObject parts;
        for (const Cut& cut : object.cut(section.axis, position_on_axis(section, box_))) {
            parts.lines.push_back(project(cut, projection, options.mm_per_unit));
            if (parts.lines.back().closed) parts.wall.push_back(positions_of(parts.lines.back()));
        }
        objects.push_back(std::move(parts));
    }
    add_walls(std::move(objects), drawn);
    return drawn;
}

}  // namespace line_drawing
