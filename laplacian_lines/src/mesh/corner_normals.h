// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "mesh/corner_table.h"
#include "mesh/flat_faces.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// By corner of a triangle, 3 t + k: the mean of the normals of the flat faces around its vertex
/// that no sharp edge parts from it, weighted by their areas and by the angles there. Large faces
/// are flat up to the fillets beside them.
class CornerNormals {
public:
    /// Keeps a reference to the mesh.
    CornerNormals(const PreparedMesh& mesh, const CornerTable& sides, const FlatFaces& faces);

    Eigen::Vector3d normal(std::uint32_t corner) const {
        return sums_[group_of_[corner]].stableNormalized();
    }

    /// Whether its normal is not that of its triangle, as on curved surfaces.
    bool is_bent(std::uint32_t corner) const { return is_bent_[corner]; }

    struct AtVertex {
        /// Of all its corners, or of those on the largest curved surface; 0 if there is none.
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        bool is_sharp = false;  ///< not all of its corners have one normal
    };
    std::vector<AtVertex> at_vertices() const;

private:
    const PreparedMesh& mesh_;
    std::vector<std::uint32_t> group_of_;  // corners of a vertex that have one normal
    std::vector<Eigen::Vector3d> sums_;    // by group, which is its first corner
    std::vector<std::uint8_t> is_bent_;    // by corner
};

}  // namespace laplacian_lines
