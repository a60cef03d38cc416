// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "rounded_walls.h"

namespace test_meshes {

/// A block, [−1, 1] x [−0.6, 0.6] x [−0.4, 0.4], with a slot along y, a step at its right end and
/// an upright hole through the step, all right-angled.
class MachinedPart {
public:
    /// Fillets on all edges, also concave ones; radius in D.
    explicit MachinedPart(double fillet_radius);

    static double diagonal();  ///< D
    Wall wall(const Eigen::Vector3d& p) const;
    /// Triangles with about this edge, in D.
    laplacian_lines::TriangleMesh mesh(double edge) const;
    /// Pieces of up to 0.5 % of D.
    std::vector<ArrisPiece> arrises() const;

private:
    double radius_;
};

/// The part with sharp edges and minimal triangles, like CAD programs write. The hole has 32 sides.
laplacian_lines::TriangleMesh sharp_part();

namespace part {

constexpr double kLength = 1, kDepth = 0.6, kHeight = 0.4;  ///< half edges of the block
constexpr double kSlotLeft = -0.55, kSlotRight = -0.25, kSlotBottom = 0.1;  ///< x, x, z
constexpr double kStepLeft = 0.4, kStepTop = 0;                             ///< x, z
constexpr double kHoleX = 0.7, kHoleRadius = 0.2;                           ///< y = 0

/// Seen along −y, (x, z), the solid to the left.
inline std::vector<Eigen::Vector2d> profile() {
    return {{-kLength, -kHeight},      {kLength, -kHeight},      {kLength, kStepTop},
            {kStepLeft, kStepTop},     {kStepLeft, kHeight},     {kSlotRight, kHeight},
            {kSlotRight, kSlotBottom}, {kSlotLeft, kSlotBottom}, {kSlotLeft, kHeight},
            {-kLength, kHeight}};
}

}  // namespace part

}  // namespace test_meshes
