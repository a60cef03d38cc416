// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/view_strokes.h"

#include <algorithm>
#include <array>

#include "options/paper_and_pens.h"
#include "planes/corners.h"
#include "sheet/view_drawing.h"
#include "sight/object_lines.h"
#include "sight/view_builder.h"
#include "strokes/strokes.h"

namespace line_drawing {
namespace {

using Eigen::Vector3d;
using laplacian_lines::part;
using laplacian_lines::ViewLine;
using laplacian_lines::ViewLinePoint;

// Progress at which lines are found, and visibility is prepared.
constexpr double kLinesShare = 0.5, kSightShare = 0.7;

constexpr double kTolerance = 0.01;  // mm on paper, of corners
// A change in depth of so much, in D, over steps so steep, leads to another line behind the first.
constexpr double kLeastJump = 0.02, kSteepest = 10;
// In inner pens: shorter parts of a stroke beyond such a place are dropped.
constexpr double kShortestRemains = 6;

/// Moves the strokes of a view from paper to space.
class InSpace {
public:
    InSpace(const Projection& projection, const Placement& placement, double diagonal, double pen)
        : projection_(projection),
          placement_(placement),
          least_jump_(kLeastJump * diagonal * placement.scale),
          shortest_remains_(kShortestRemains * pen) {}

    void append(const DrawnLine& stroke, std::vector<ViewLine>& lines) const {
        std::vector<Vector3d> places;  // x and y on paper, and depth
        for (const DrawnPoint& point : stroke.points)
            places.emplace_back(point.position.x(), point.position.y(),
                                placement_.scale * point.origin.depth);
        std::size_t begin = 0;
        for (std::size_t i = 0; i + 1 < places.size();) {
            const std::size_t end = end_of_steep(places, i);
            if (std::abs(places[end].z() - places[i].z()) > least_jump_) {
                append_part(stroke, places, begin, i, lines);
                begin = end;
            }
            i = std::max(end, i + 1);
        }
        append_part(stroke, places, begin, places.size() - 1, lines);
    }

private:
    /// The end of the run of steps that are steep in the same direction from this point on.
    static std::size_t end_of_steep(const std::vector<Vector3d>& places, std::size_t i) {
        const bool goes_back = places[i + 1].z() > places[i].z();
        const auto is_steep = [&](const Vector3d& step) {
            return (goes_back ? step.z() : -step.z()) > kSteepest * step.head<2>().norm();
        };
        while (i + 1 < places.size() && is_steep(places[i + 1] - places[i]))
            ++i;
        return i;
    }

    void append_part(const DrawnLine& stroke, const std::vector<Vector3d>& places,
                     std::size_t first, std::size_t last, std::vector<ViewLine>& lines) const {
        if (last <= first) return;
        const bool is_first = first == 0, is_last = last + 1 == places.size(),
                   is_whole = is_first && is_last;
        const bool is_at_seam = stroke.closed && (is_first || is_last);
        double length = 0;
        for (std::size_t i = first; i < last; ++i)
            length += (places[i + 1] - places[i]).head<2>().norm();
        if (!is_whole && !is_at_seam && length < shortest_remains_) return;
        ViewLine line;
        const LineOrigin& most = most_of(stroke, first, last);
        line.kind = most.kind;
        line.strength = most.strength;
        line.slope = most.slope;
        line.closed = stroke.closed && is_whole;
        line.is_hidden = stroke.line_class == LineClass::Hidden;
        line.is_outline = stroke.line_class == LineClass::Outline;
        line.jump = 0;
        std::vector<std::size_t> corners = corners_of(places, first, last, kTolerance);
        corners.push_back(last);
        for (const std::size_t i : corners)
            line.points.push_back(point_of(stroke.points[i]));
        if (line.closed) line.points.back().position = line.points.front().position;
        lines.push_back(std::move(line));
    }

    ViewLinePoint point_of(const DrawnPoint& point) const {
        const Eigen::Vector2d shift = (point.position - placement_.middle) / placement_.scale;
        const Vector3d place = projection_.unproject({shift.x(), -shift.y()}, point.origin.depth);
        return {place, float(point.weight),      point.origin.gradient,
                1,     laplacian_lines::kNoNode, point.is_exact};
    }

    /// The origin of a point of the most frequent kind.
    static const LineOrigin& most_of(const DrawnLine& stroke, std::size_t first, std::size_t last) {
        std::array<std::size_t, laplacian_lines::kLineKindCount> counts{};
        std::size_t most = first;
        const auto count_of = [&](std::size_t i) -> std::size_t& {
            return counts.at(std::size_t(stroke.points[i].origin.kind));
        };
        for (std::size_t i = first; i <= last; ++i)
            if (++count_of(i) > count_of(most)) most = i;
        return stroke.points[most].origin;
    }

    const Projection& projection_;
    const Placement& placement_;
    const double least_jump_, shortest_remains_;  // mm on paper
};

}  // namespace

std::vector<ViewLine> strokes_of(const Objects& objects, const ViewFrame& frame,
                                 SheetOptions options, const laplacian_lines::Progress& progress,
                                 double size) {
    options.mm_per_unit = 1;
    ViewBuilder builder(objects);
    DrawnView drawn = builder.empty_view(frame, options);
    const Placement placement{size / drawn.bounds.sizes().maxCoeff(), {0, 0}};
    options.pens = pens_for(size, options.pens);
    {
        ObjectLines lines(objects);
        lines.prepare(options, placement.scale, Kernel::Exact, part(progress, 0, kLinesShare));
        options.kernel = {lines.kernel_size() * placement.scale, false};
        const auto found = lines.extract(builder.view_of(drawn, options), options.style);
        builder.prepare({options}, part(progress, kLinesShare, kSightShare));
        builder.add_lines(drawn, found, options, part(progress, kSightShare, 1));
    }
    const Projection projection(drawn.frame, builder.middle());
    const InSpace in_space(projection, placement, builder.object_size().norm(),
                           options.pens[std::size_t(LineClass::Inner)]);
    std::vector<ViewLine> lines;
    for (const DrawnLine& stroke : draw_lines(drawn, placement, options))
        if (draw_stroke(stroke, options)) in_space.append(stroke, lines);
    return lines;
}

}  // namespace line_drawing
