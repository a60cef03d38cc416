// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "laplacian_lines/line_visibility.h"
#include "planes/cutting.h"

namespace line_drawing {

/// normal · p >= offset, mesh coordinates.
struct HalfSpace {
    Eigen::Vector3d normal;
    double offset;

    double depth(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
    HalfSpace opposite() const { return {-normal, -offset}; }
};

/// Parts inside, which end on the plane. Closed lines inside stay closed.
laplacian_lines::LineSet clip(const laplacian_lines::LineSet& lines, const HalfSpace& inside);
std::vector<laplacian_lines::SightLine> clip(const std::vector<laplacian_lines::SightLine>& lines,
                                             const HalfSpace& inside);
std::vector<Cut> clip(const std::vector<Cut>& lines, const HalfSpace& inside);

/// A loop around what is within both (even-odd); it may run along the plane several times.
Cut clipLoop(const Cut& loop, const HalfSpace& inside);

/// The surface inside; cuts triangles along the plane.
laplacian_lines::TriangleMesh clip(const laplacian_lines::TriangleMesh& mesh,
                                   const HalfSpace& inside);

}  // namespace line_drawing
