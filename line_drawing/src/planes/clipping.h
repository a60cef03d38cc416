// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/line_set.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/triangle_mesh.h"
#include "planes/cutting.h"

namespace line_drawing {

/// normal · p >= offset, mesh coordinates.
struct HalfSpace {
    Eigen::Vector3d normal;
    double offset;

    double depth(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
    HalfSpace opposite() const { return {-normal, -offset}; }
};

/// The parts inside, cut on the plane. Closed lines inside stay closed; others, but for a Cut, are
/// also cut where they begin. What a line tells of its whole length, such as its strength, stays.
laplacian_lines::LineSet clip(const laplacian_lines::LineSet& lines, const HalfSpace& inside);
std::vector<laplacian_lines::ViewLine> clip(const std::vector<laplacian_lines::ViewLine>& lines,
                                            const HalfSpace& inside);
std::vector<Cut> clip(const std::vector<Cut>& lines, const HalfSpace& inside);

/// A loop around the part inside of a loop's area (even-odd); may run along the plane repeatedly.
Cut clip_loop(const Cut& loop, const HalfSpace& inside);

/// The part of the surface inside; cuts triangles along the plane.
laplacian_lines::TriangleMesh clip(const laplacian_lines::TriangleMesh& mesh,
                                   const HalfSpace& inside);

}  // namespace line_drawing
