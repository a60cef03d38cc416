// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections/half_section.h"

#include <algorithm>
#include <cmath>

#include "line_drawing/words.h"
#include "sections/wall_area.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double level_share = 0.003;  // of the height: what counts as the level of rim or base
constexpr double least_span = 0.1;     // of the height: a round base is not a line

// For VesselAxis. Of a cube .25 is round; a pot of 200 mm that leans by 5 degrees has its section 9
// mm off its axis at both ends.
constexpr double least_round = 0.4, least_rim = 0.5, most_lean = 5;

std::string percent(double share) {
    return inDigits(std::floor(100 * share + 1e-9)) + " %";
}

int axisAlong(const Vector3d& direction) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return axis;
}

DrawnLine lineOf(const Vector2d& begin, const Vector2d& end) {
    return {LineClass::Inner, false, {{begin, 1}, {end, 1}}};
}

/// The outermost point near the height of the highest (`sign` 1) or lowest (−1) one.
struct Level {
    Vector2d left, right;
};
Level levelOf(const std::vector<Vector2d>& points, double sign, double reach) {
    double height = -INFINITY;
    for (const Vector2d& p : points)
        height = std::max(height, sign * p.y());
    Level level{{INFINITY, 0}, {-INFINITY, 0}};
    for (const Vector2d& p : points) {
        if (sign * p.y() < height - reach) continue;
        if (p.x() < level.left.x()) level.left = p;
        if (p.x() > level.right.x()) level.right = p;
    }
    return level;
}

}  // namespace

HalfSection::HalfSection(const laplacian_lines::TriangleMesh& all, const ViewFrame& frame)
    : axis_(findAxis(all, axisAlong(frame.up), frame.up.sum() > 0)),
      behind_{-frame.towards_viewer, -frame.towards_viewer.dot(axis_.point)},
      right_{frame.right, frame.right.dot(axis_.point)} {}

void HalfSection::expectVessel() const {
    const auto say = [](const std::string& what) {
        refuse(what +
               " Vessel views take a vessel that stands upright, nearly whole. Fix that, or "
               "take other views and a section.");
    };
    if (axis_.round < least_round)
        say("Of what faces sideways, only " + percent(axis_.round) + " is round about one axis.");
    if (axis_.lean > most_lean)
        say("The vessel's axis leans by " + inDecimals(axis_.lean, 0) + " degrees.");
    if (axis_.rim < least_rim)
        say("The rim goes only " + percent(axis_.rim) + " of the way around the axis.");
}

std::string HalfSection::words() const {
    return "rim " + percent(axis_.rim) + ", axis off by " + inDecimals(axis_.lean, 1) + "°";
}

void HalfSection::draw(DrawnView& drawn, const std::vector<CuttableMesh>& all,
                       const Vector3d& middle, double unit) const {
    const int across = axisAlong(behind_.normal);
    const Projection projection(drawn.frame, middle);
    const auto flat = [&](const Cut& cut) { return positionsOf(project(cut, projection, unit)); };
    std::vector<Vector2d> points;
    std::vector<CutObject> objects;
    for (const CuttableMesh& object : all) {
        CutObject parts;
        std::vector<Cut> cut_lines;
        for (Cut& cut : object.cut(across, axis_.point[across])) {
            const std::vector<Vector2d> line = flat(cut);
            points.insert(points.end(), line.begin(), line.end());
            const Cut loop = cut.front() == cut.back() ? clipLoop(cut, left()) : Cut();
            if (!loop.empty()) parts.wall.push_back(flat(loop));
            cut_lines.push_back(std::move(cut));
        }
        drawn.lines = withoutPartsIn(WallArea(parts.wall), drawn.lines);
        for (const Cut& cut : clip(cut_lines, left()))
            parts.lines.push_back(project(cut, projection, unit));
        objects.push_back(std::move(parts));
    }
    addWalls(objects, drawn);
    if (points.empty()) return;
    const double height = drawn.bounds.sizes().y(), at = unit * right_.depth(middle);
    const Level rim = levelOf(points, 1, level_share * height),
                base = levelOf(points, -1, level_share * height);
    for (const Level& level : {rim, base})
        if (level.right.x() - level.left.x() > least_span * height)
            drawn.lines.push_back(lineOf(level.left, level.right));
    drawn.lines.push_back(lineOf({-at, rim.left.y()}, {-at, base.left.y()}));
}

}  // namespace line_drawing
