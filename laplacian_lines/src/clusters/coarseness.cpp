// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/coarseness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "field/field_steps.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// In D: about two pixels of a picture of 400.
constexpr double kFarthestContour = 0.006;
constexpr double kLargestSmoothTriangle = 0.03;  // longest edge, D
constexpr double kLargestRoughTriangle = 0.06;   // whose contours are smooth on rough meshes, D
// Of the area. Measured meshes may have a few large triangles, where holes were filled.
constexpr double kCoarseShare = 0.25, kCoarseShareOfCad = 0.02;
constexpr double kSquaredCosineOfCad = 0.9698;  // of 10°

constexpr double kFlat = 0.9999984769132877;   // least cosine: of 0.1°
constexpr double kSharp = 0.7660444431189781;  // most cosine: of 40°
constexpr double kLong = 0.02;                 // D

double longest_squared(const PreparedMesh& mesh, const Triangle& t) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest,
                           (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).squaredNorm());
    return longest;
}

/// Whether the zero of n·l in a triangle may be far from the horizon of the triangles.
bool is_coarse(const PreparedMesh& mesh, const Field& field, const Triangle& t, bool is_cad) {
    const double squared_size = longest_squared(mesh, t);
    const auto is_larger = [&](double size) { return squared_size > size * size; };
    if (is_rough(field.report)) return is_larger(kLargestRoughTriangle);
    const Eigen::Vector3d plane = area_vector(mesh, t);
    double least = 1;  // squared cosine of the corner that leans most, 0 from 90° on
    for (const std::uint32_t v : t) {
        const Eigen::Vector3d n = field.normals[mesh.original_vertex[v]].cast<double>();
        const double cosine = n.dot(plane), squares = plane.squaredNorm() * n.squaredNorm();
        least = std::min(least, cosine > 0 && squares > 0 ? cosine * cosine / squares : 0);
    }
    return is_larger(kLargestSmoothTriangle) ||
           squared_size * (1 - least) > kFarthestContour * kFarthestContour ||
           (is_cad && least < kSquaredCosineOfCad);
}

/// By vertex, the least cosine between the planes of the triangles around it and of the first one,
/// whichever side each of them is seen from.
std::vector<double> least_cosines(const PreparedMesh& mesh) {
    std::vector<Eigen::Vector3d> normals = large_array<Eigen::Vector3d>(mesh.triangles.size());
    for_each_element(normals.size(), [&](std::size_t t) {
        normals[t] = area_vector(mesh, mesh.triangles[t]).stableNormalized();
    });
    std::vector<const Eigen::Vector3d*> first(mesh.size(), nullptr);
    std::vector<double> least(mesh.size(), 1);
    for (std::size_t t = 0; t < normals.size(); ++t)
        for (const std::uint32_t v : mesh.triangles[t]) {
            if (!first[v]) first[v] = &normals[t];
            least[v] = std::min(least[v], std::abs(normals[t].dot(*first[v])));
        }
    return least;
}

}  // namespace

bool is_rough(const MeshReport& report) {
    return report.roughness > kLargestRoughness;
}

bool follows_edges(const PreparedMesh& mesh, bool is_cad, const Field& field) {
    const auto area = [&](std::size_t i) { return area_vector(mesh, mesh.triangles[i]).norm(); };
    const double all = sum_of(mesh.triangles.size(), area);
    const double coarse = sum_of(mesh.triangles.size(), [&](std::size_t i) {
        return is_coarse(mesh, field, mesh.triangles[i], is_cad) ? area(i) : 0;
    });
    return coarse > (is_cad && !is_rough(field.report) ? kCoarseShareOfCad : kCoarseShare) * all;
}

std::vector<std::uint8_t> find_featureless_triangles(const PreparedMesh& mesh) {
    std::vector<std::uint8_t> featureless(mesh.triangles.size(), 0);
    const std::vector<double> cosines = least_cosines(mesh);
    const auto is_sharp = [&](double cosine) { return cosine <= kSharp; };
    if (std::none_of(cosines.begin(), cosines.end(), is_sharp)) return featureless;
    for_each_element(featureless.size(), [&](std::size_t i) {
        const Triangle& t = mesh.triangles[i];
        const auto is_flat = [&](std::uint32_t v) { return cosines[v] >= kFlat; };
        const auto is_clear = [&](std::uint32_t v) { return is_flat(v) || is_sharp(cosines[v]); };
        featureless[i] =
            std::all_of(t.begin(), t.end(), is_flat) ||
            (std::all_of(t.begin(), t.end(), is_clear) && longest_squared(mesh, t) > kLong * kLong);
    });
    return featureless;
}

}  // namespace laplacian_lines
