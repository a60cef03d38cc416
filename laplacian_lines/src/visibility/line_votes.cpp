// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/line_votes.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

// In D unless something else is said.
constexpr double kSpacing = 0.003;  // of rays along a line
/// A ray of a contour: where it begins beside it in the picture, where it passes the contour's own
/// surface, in mean edges, and how much nearer to the eye, in clearances.
struct ContourRay {
    double aside, towards_eye;
};
constexpr ContourRay kContourRays[] = {{0.05, 0.1}, {0.2, 0.3}, {0.5, 1}};
constexpr double kFarthestAside = 0.0015;
// How far beside a contour, and before and behind it, its surface is looked for.
constexpr double kSideAside = 0.0007, kSideReach = 0.05;
constexpr double kInside = 0.002;  // below the surface

}  // namespace

std::vector<PlacedPiece> LineVotes::pieces(const std::vector<LinePlace>& places) const {
    std::vector<PlacedPiece> result;
    for (const LinePiece& piece : pieces_of(lines_, line_, kSpacing * lengths_.diagonal, places)) {
        const Vector3d middle = place(middle_place(piece));
        const Vector3d way = place(piece.end) - place(piece.begin);
        const Vector3d across = (side_ < 0 ? -1 : 1) * way.cross(sight_.towards_eye(middle));
        result.push_back({piece, middle, across, across.stableNormalized()});
    }
    return result;
}

double LineVotes::share_seen(const Vector3d& p, const Vector3d& aside) {
    const double clearance = lengths_.clearance(line_.kind);
    if (!describe(line_.kind).is_on_horizon) return sight_.is_clear(p, clearance, 0);
    double seen = 0;
    int number = 0;
    for (const ContourRay& ray : kContourRays) {
        const Vector3d step =
            std::min(ray.aside * lengths_.mean_edge, kFarthestAside * lengths_.diagonal) * aside;
        seen += sight_.is_clear(p + step, ray.towards_eye * clearance, number++);
    }
    return seen / number;
}

bool LineVotes::is_before_surface(const PlacedPiece& piece) {
    return sight_.meets_surface(piece.middle + kInside * lengths_.diagonal * piece.aside,
                                piece.aside);
}

double LineVotes::facing(const PlacedPiece& piece) const {
    return sight_.facing(piece.middle, piece.aside, lengths_.clearance(line_.kind));
}

int LineVotes::surface_across(const PlacedPiece& piece) {
    const Vector3d step = kSideAside * lengths_.diagonal * piece.aside;
    const double reach = kSideReach * lengths_.diagonal;
    return int(sight_.is_near_surface(piece.middle - step, reach)) -
           int(sight_.is_near_surface(piece.middle + step, reach));
}

}  // namespace laplacian_lines
