// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flat_faces.h"

#include "system/disjoint_sets.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// Shares of the area. Segmented heads and ellipsoids of 40 to 100 voxels have up to 0.16 in large
// faces, but 0.54 if they are as flat as a lens; housings and plates have from 0.40 on.
constexpr double kLargeFace = 0.02, kShareOfLarge = 0.33;

}  // namespace

bool FlatFaces::are_large() const {
    return large_share > kShareOfLarge;
}

FlatFaces flat_faces(const PreparedMesh& mesh, const CornerTable& sides) {
    const std::size_t count = mesh.triangles.size();
    std::vector<Eigen::Vector3d> normals(count);
    std::vector<double> areas(count);
    for_each_element(count, [&](std::size_t t) {
        const Eigen::Vector3d area = area_vector(mesh, mesh.triangles[t]);
        areas[t] = area.norm();
        normals[t] = area.stableNormalized();
    });
    DisjointSets faces(count);
    for (std::uint32_t side = 0; side < sides.side_count(); ++side) {
        const std::uint32_t t = side / 3, other = sides.across(side) / 3;
        if (sides.has_neighbour(side) && t < other && normals[other].dot(normals[t]) >= kFlatCosine)
            faces.unite(t, other);
    }
    const std::vector<std::uint32_t> face_of = faces.take_roots();
    std::vector<double> face_areas(count, 0);
    std::vector<std::uint8_t> has_several(count, 0);
    for (std::uint32_t t = 0; t < count; ++t) {
        face_areas[face_of[t]] += areas[t];
        if (face_of[t] != t) has_several[face_of[t]] = 1;
    }
    const double all = sum_of(count, [&](std::size_t t) { return areas[t]; });
    const auto share_of = [&](auto is_counted) {
        return sum_of(count, [&](std::size_t t) { return is_counted(face_of[t]) ? areas[t] : 0; }) /
               all;
    };
    return {share_of([&](std::uint32_t face) { return has_several[face]; }),
            share_of([&](std::uint32_t face) { return face_areas[face] >= kLargeFace * all; })};
}

}  // namespace laplacian_lines
