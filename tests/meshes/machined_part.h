// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "arris.h"
#include "laplacian_lines/triangle_mesh.h"
#include "rounded_walls.h"

namespace test_meshes {

/// A block, [−1, 1] x [−0.6, 0.6] x [−0.4, 0.4], with a slot along y, a step at its right end and
/// an upright hole through the step. All its edges are right-angled.
class MachinedPart {
public:
    /// With fillets on all edges, concave ones too; the radius is in D.
    explicit MachinedPart(double fillet_radius);

    static double diagonal();  ///< D
    Wall wall(const Eigen::Vector3d& p) const;
    /// With triangles of about the given edge, in D.
    laplacian_lines::TriangleMesh mesh(double edge) const;
    /// Of pieces of up to 0.5 % of D.
    std::vector<ArrisPiece> arrises() const;

private:
    double radius_;
};

/// The same part with sharp edges and as few triangles as it can do with: what CAD programs write.
/// The hole has 32 sides.
laplacian_lines::TriangleMesh sharp_part();

}  // namespace test_meshes
