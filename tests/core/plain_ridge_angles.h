// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/triangle_mesh.h"
#include "plain_ridges.h"

namespace reference {

/// A point of a candidate of ridges, on an edge of the mesh.
struct RidgePoint {
    Edge edge;
    Eigen::Vector3d position;  ///< mesh coordinates
    Eigen::Vector3d normal;    ///< of any length
    Eigen::Vector3d bend;      ///< k₁ e₁ of either sign, times any length
};

struct RidgeAngle {
    double angle;              ///< degrees
    Eigen::Vector3d position;  ///< moved to the middle of the turn, mesh coordinates
};

/// What sections across candidate lines tell of their edges, as docs/drawing.md has it, in double
/// precision; for clean meshes.
class PlainRidgeAngles {
public:
    /// Keeps both by reference. `kind`: Ridge or Valley.
    PlainRidgeAngles(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Field& field,
                     laplacian_lines::LineKind kind);

    /// By point of a line.
    std::vector<RidgeAngle> measure(const std::vector<RidgePoint>& line) const;

private:
    struct Place {
        double distance, angle;    // D, degrees
        Eigen::Vector3d position;  // mesh coordinates
    };
    /// From the point to either side: to the right of the line, and to its left.
    struct Section {
        std::vector<Place> sides[2];
        Place at(double distance) const;  // on the right it is negative, and so is the angle
        double middle() const;
    };

    Section section(const std::vector<RidgePoint>& line, const std::vector<double>& ways,
                    std::size_t i) const;
    std::vector<Place> walk(const RidgePoint& from, const Eigen::Vector3d& forward,
                            const Eigen::Vector3d& origin, const Eigen::Vector3d& across_plane,
                            std::size_t triangle) const;

    const laplacian_lines::TriangleMesh& mesh_;
    const laplacian_lines::Field& field_;
    const double sign_;
    std::map<Edge, std::vector<std::size_t>> triangles_;  // at each edge
};

}  // namespace reference
