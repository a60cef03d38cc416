// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flat_faces.h"

#include <algorithm>
#include <cmath>

#include "system/disjoint_sets.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// Shares of the area. Segmented heads and ellipsoids of 40 to 100 voxels have up to 0.16 in large
// faces, but 0.54 if they are as flat as a lens; housings and plates have from 0.40 on.
constexpr double kLargeFace = 0.02, kShareOfLarge = 0.33;

// Facets of one curved surface are about as wide as the next ones, at least a quarter, along much
// of their bounds. By that alone, wide facets between fans of slivers would be faces of the form.
constexpr double kLikeWidth = 0.25, kMostAlike = 0.25;
constexpr double kLeastBulge = 5e-4;  // D: a tenth of a millimetre of a drawing

// Of a face's area, of the sum of its vectors: neighbours within .1° may turn by more together.
constexpr double kFlatShare = 0.9998;  // 1° to each side

/// What bounds a face, local units. Soft: at less than a sharp edge's angle.
struct Bounds {
    double length = 0, soft_length = 0;
    double alike_length = 0;  // of soft bounds to faces about as wide
    double soft_angle = 0;    // mean
    double width = 0;         // of the strip of this area between the soft bounds

    /// Whether it is no facet of a curved surface.
    bool is_no_facet() const {
        return alike_length < kMostAlike * length && width * soft_angle / 8 > kLeastBulge;
    }
};

/// Calls visit(face, length, cosine, other face) for the sides between faces; the cosine is -1 at
/// borders. On meshes that are not CAD for faces of several alone.
template <class Visit>
void for_each_bound(const PreparedMesh& mesh, const CornerTable& sides, const FlatFaces& faces,
                    Visit visit) {
    for (std::uint32_t side = 0; side < sides.side_count(); ++side) {
        const std::uint32_t t = side / 3, face = faces.face_of[t];
        if (!faces.has_several[face] && !faces.is_cad_mesh()) continue;
        const bool has_other = sides.has_neighbour(side);
        const std::uint32_t u = has_other ? sides.across(side) / 3 : t, other = faces.face_of[u];
        if (has_other && other == face) continue;
        const auto [a, b] = edge_of(mesh.triangles, side);
        visit(face, (mesh.positions[b] - mesh.positions[a]).norm(),
              has_other ? faces.normals[t].dot(faces.normals[u]) : -1, other);
    }
}

/// By first triangle.
std::vector<Bounds> bounds_of(const PreparedMesh& mesh, const CornerTable& sides,
                              const FlatFaces& faces) {
    std::vector<Bounds> bounds(faces.face_of.size());
    for_each_bound(mesh, sides, faces,
                   [&](std::uint32_t face, double length, double cosine, std::uint32_t) {
                       bounds[face].length += length;
                       if (cosine <= kSharpCosine) return;
                       bounds[face].soft_length += length;
                       bounds[face].soft_angle += length * std::acos(std::min(cosine, 1.));
                   });
    for (std::size_t face = 0; face < bounds.size(); ++face) {
        Bounds& b = bounds[face];
        if (b.soft_length == 0) continue;
        b.soft_angle /= b.soft_length;
        b.width = faces.areas[face] / b.soft_length;
    }
    for_each_bound(
        mesh, sides, faces,
        [&](std::uint32_t face, double length, double cosine, std::uint32_t other) {
            if (cosine > kSharpCosine && bounds[other].width > kLikeWidth * bounds[face].width)
                bounds[face].alike_length += length;
        });
    return bounds;
}

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
        return sum_of(count,
                      [&](std::size_t t) { return is_counted(faces.face_of[t]) ? areas[t] : 0; }) /
               all;
    };
    faces.share = share_of([&](std::uint32_t face) { return faces.has_several[face]; });
    faces.large_share =
        share_of([&](std::uint32_t face) { return faces.areas[face] >= kLargeFace * all; });
    return faces;
}

std::vector<FaceShape> face_shapes(const PreparedMesh& mesh, const CornerTable& sides,
                                   const FlatFaces& faces) {
    // by first triangle: normals times areas, twice, and whether it goes on softly
    std::vector<Eigen::Vector3d> vectors(faces.face_of.size(), Eigen::Vector3d::Zero());
    std::vector<std::uint8_t> goes_on(faces.face_of.size());
    for (std::size_t t = 0; t < vectors.size(); ++t)
        if (faces.has_several[faces.face_of[t]])
            vectors[faces.face_of[t]] += area_vector(mesh, mesh.triangles[t]);
    for_each_bound(mesh, sides, faces,
                   [&](std::uint32_t face, double, double cosine, std::uint32_t) {
                       if (cosine > kSharpCosine) goes_on[face] = 1;
                   });
    std::vector<Bounds> bounds;
    if (faces.is_cad_mesh()) bounds = bounds_of(mesh, sides, faces);
    std::vector<FaceShape> shapes(faces.face_of.size(), FaceShape::Curved);
    for_each_element(shapes.size(), [&](std::size_t t) {
        const std::uint32_t face = faces.face_of[t];
        if (!faces.has_several[face] || vectors[face].norm() < kFlatShare * faces.areas[face])
            return;
        if (!goes_on[face])
            shapes[t] = FaceShape::Enclosed;
        else if (faces.is_cad_mesh() && bounds[face].is_no_facet())
            shapes[t] = FaceShape::Flat;
    });
    return shapes;
}

}  // namespace laplacian_lines
