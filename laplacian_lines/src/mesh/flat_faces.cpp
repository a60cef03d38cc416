// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flat_faces.h"

#include "mesh/corner_normals.h"
#include "system/disjoint_sets.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// Shares of the area. Segmented heads and ellipsoids of 40 to 100 voxels have up to 0.16 in large
// faces, but 0.54 if they are as flat as a lens; housings and plates have from 0.40 on.
constexpr double kLargeFace = 0.02, kShareOfLarge = 0.33;

// Least length of the sum of a flat face's area vectors, in its area: neighbours within .1° may
// turn by more together. This is that of a cylinder's part that turns by 2° to each side, or of two
// planes that meet at 2.3°.
constexpr double kFlatShare = 0.9998;

}  // namespace

bool FlatFaces::are_large() const {
    return large_share > kShareOfLarge;
}

FlatFaces flat_faces(const PreparedMesh& mesh, const CornerTable& sides) {
    const std::size_t count = mesh.triangles.size();
    FlatFaces faces;
    faces.normals.resize(count);
    std::vector<double> areas(count);
    for_each_element(count, [&](std::size_t t) {
        const Eigen::Vector3d area = area_vector(mesh, mesh.triangles[t]);
        areas[t] = area.norm();
        faces.normals[t] = area.stableNormalized();
    });
    DisjointSets sets(count);
    for (std::uint32_t side = 0; side < sides.side_count(); ++side) {
        const std::uint32_t t = side / 3, other = sides.across(side) / 3;
        if (sides.has_neighbour(side) && t < other &&
            faces.normals[other].dot(faces.normals[t]) >= kFlatCosine)
            sets.unite(t, other);
    }
    faces.face_of = sets.take_roots();
    faces.areas.resize(count);
    faces.has_several.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        faces.areas[faces.face_of[t]] += areas[t];
        if (faces.face_of[t] != t) faces.has_several[faces.face_of[t]] = 1;
    }
    const double all = sum_of(count, [&](std::size_t t) { return areas[t]; });
    const auto share_of = [&](auto is_counted) {
        return sum_of(count, [&](std::size_t t) { return is_counted(t) ? areas[t] : 0; }) / all;
    };
    faces.share = share_of([&](std::size_t t) { return faces.has_several[faces.face_of[t]]; });
    faces.large_share =
        share_of([&](std::size_t t) { return faces.areas[faces.face_of[t]] >= kLargeFace * all; });
    faces.narrow_share = share_of([&](std::size_t t) {
        return longest_squared(mesh.positions, mesh.triangles[t]) >= kNarrow * areas[t];
    });
    return faces;
}

std::vector<FaceShape> face_shapes(const PreparedMesh& mesh, const CornerTable& sides,
                                   const FlatFaces& faces) {
    // by first triangle: the sum of area vectors; whether an edge is not sharp; whether a corner's
    // normal is not the face's, or may not be, where normals are those of a scan
    std::vector<Eigen::Vector3d> vectors(faces.face_of.size(), Eigen::Vector3d::Zero());
    std::vector<std::uint8_t> goes_on(faces.face_of.size()), bends(faces.face_of.size(), 1);
    for (std::uint32_t t = 0; t < faces.face_of.size(); ++t)
        vectors[faces.face_of[t]] += area_vector(mesh, mesh.triangles[t]);
    for (std::uint32_t side = 0; side < sides.side_count(); ++side) {
        const std::uint32_t t = side / 3, face = faces.face_of[t];
        if (!faces.has_several[face] || !sides.has_neighbour(side)) continue;
        const std::uint32_t other = sides.across(side) / 3;
        if (faces.face_of[other] != face &&
            faces.normals[t].dot(faces.normals[other]) > kSharpCosine)
            goes_on[face] = 1;
    }
    if (faces.is_cad_mesh()) {
        const CornerNormals corners(mesh, sides, faces);
        bends.assign(bends.size(), 0);
        for (std::uint32_t corner = 0; corner < sides.side_count(); ++corner)
            if (corners.is_bent(corner)) bends[faces.face_of[corner / 3]] = 1;
    }
    std::vector<FaceShape> shapes(faces.face_of.size(), FaceShape::Curved);
    for_each_element(shapes.size(), [&](std::size_t t) {
        const std::uint32_t face = faces.face_of[t];
        if (!faces.has_several[face] || vectors[face].norm() < kFlatShare * faces.areas[face])
            return;
        if (!goes_on[face])
            shapes[t] = FaceShape::Enclosed;
        else if (!bends[face])
            shapes[t] = FaceShape::Flat;
    });
    return shapes;
}

}  // namespace laplacian_lines
