// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/triangle_mesh.h"

namespace line_drawing {

/// A line where a plane cuts a surface; a closed one repeats its first point.
using Cut = std::vector<Eigen::Vector3d>;

/// A mesh, which outlives it, to be cut by any number of planes.
class CuttableMesh {
public:
    explicit CuttableMesh(const laplacian_lines::TriangleMesh& mesh)
        : positions_(mesh.positions), triangles_(conforming_triangles(mesh)) {}

    /// The intersection with the plane at `height` along a mesh axis, in mesh coordinates and in
    /// the order of the triangles: closed lines for closed surfaces, even if triangles share
    /// positions only, not vertices.
    std::vector<Cut> cut(int axis, double height) const;

private:
    const std::vector<Eigen::Vector3d>& positions_;
    const std::vector<laplacian_lines::Triangle> triangles_;
};

using Loops = std::vector<std::vector<Eigen::Vector2d>>;

/// Positions, ascending, along the line in the unit direction `direction`, `offset` to the left of
/// the origin, at which it enters and leaves the area that loops enclose (even-odd).
std::vector<double> crossings_at(const Loops& loops, const Eigen::Vector2d& direction,
                                 double offset);

/// Hatching lines of two points, `spacing` apart in the unit direction `direction`, within the
/// union of areas.
std::vector<std::vector<Eigen::Vector2d>> hatch(const std::vector<Loops>& areas,
                                                const Eigen::Vector2d& direction, double spacing);

/// normal · p >= offset, mesh coordinates.
struct HalfSpace {
    Eigen::Vector3d normal;
    double offset;

    double depth(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
    HalfSpace opposite() const { return {-normal, -offset}; }
};

/// The parts inside, which end on the plane. Closed lines inside stay closed.
laplacian_lines::LineSet clip(const laplacian_lines::LineSet& lines, const HalfSpace& inside);
std::vector<laplacian_lines::ViewLine> clip(const std::vector<laplacian_lines::ViewLine>& lines,
                                            const HalfSpace& inside);
std::vector<Cut> clip(const std::vector<Cut>& lines, const HalfSpace& inside);

/// A loop around the intersection of both (even-odd); it may run along the plane several times.
Cut clip_loop(const Cut& loop, const HalfSpace& inside);

/// The part of the surface inside; cuts triangles along the plane.
laplacian_lines::TriangleMesh clip(const laplacian_lines::TriangleMesh& mesh,
                                   const HalfSpace& inside);

}  // namespace line_drawing
