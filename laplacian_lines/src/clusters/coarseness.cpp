// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/coarseness.h"

#include <algorithm>
#include <cmath>

#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr double kLargestRoughness = 0.5;  // that of noise of .074 mean edges

// The zero of n·v is where a corner's normal n is perpendicular to the ray v. The triangle's own
// plane leans from n by some angle, so such a triangle is seen at most at that angle, and its size
// times the sine is how far the zero may be from the horizon of the triangles, in the picture.
constexpr double kFarthestContour = 0.006;       // D: about two pixels of a picture of 400
constexpr double kLargestSmoothTriangle = 0.03;  // D, longest edge: corners show in contours
constexpr double kLargestRoughTriangle = 0.06;   // D: noise tilts all planes, so size alone counts
// Of the area. Measured meshes may have a few large triangles, where holes were filled; on CAD
// meshes flat faces are most of the area, and those at round ones are few.
constexpr double kCoarseShare = 0.25, kCoarseShareOfCad = 0.02;
constexpr double kSquaredCosineOfCad = 0.9698;  // of 10°: planes of CAD meshes are the form's

constexpr double kLong = 0.02;  // D: over four of the least kernels
// Where so long triangles bend as little as the facets of a cylinder of 64, the zero of a Laplacian
// is that of facets of different width.
constexpr double kVeryLong = 0.06, kGentleCosine = 0.9951;

/// Whether the zero of n·v in a triangle may be far from the horizon of the triangles.
bool is_coarse(const PreparedMesh& mesh, const Field& field, const Triangle& t, bool is_cad) {
    const double squared_size = longest_squared(mesh.positions, t);
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

/// Whether triangle a is the larger one, given normals times areas. Of equal ones it is that whose
/// normal has the larger x, then y, then z, so that the order of triangles does not matter.
bool is_larger_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double area = a.squaredNorm(), other = b.squaredNorm();
    return area != other ? area > other
                         : std::lexicographical_compare(b.begin(), b.end(), a.begin(), a.end());
}

/// By vertex, the least cosine between the planes of the triangles around it and of the largest
/// one, whichever side each of them is seen from.
std::vector<double> least_cosines(const PreparedMesh& mesh) {
    std::vector<Eigen::Vector3d> normals = large_array<Eigen::Vector3d>(mesh.triangles.size());
    for_each_element(normals.size(),
                     [&](std::size_t t) { normals[t] = area_vector(mesh, mesh.triangles[t]); });
    std::vector<const Eigen::Vector3d*> largest(mesh.size(), nullptr);
    for (std::size_t t = 0; t < normals.size(); ++t)
        for (const std::uint32_t v : mesh.triangles[t])
            if (!largest[v] || is_larger_triangle(normals[t], *largest[v]))
                largest[v] = &normals[t];
    for_each_element(normals.size(), [&](std::size_t t) { normals[t].stableNormalize(); });
    std::vector<double> least(mesh.size(), 1);
    for (std::size_t t = 0; t < normals.size(); ++t)
        for (const std::uint32_t v : mesh.triangles[t])
            least[v] = std::min(least[v], std::abs(normals[t].dot(*largest[v])));
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

std::vector<std::uint8_t> find_featureless_triangles(const PreparedMesh& mesh,
                                                     const std::vector<FaceShape>& shapes) {
    std::vector<std::uint8_t> featureless(mesh.triangles.size(), 0);
    const std::vector<double> cosines = least_cosines(mesh);
    const auto is_sharp = [&](double cosine) { return cosine <= kSharpCosine; };
    if (std::none_of(cosines.begin(), cosines.end(), is_sharp)) return featureless;
    for_each_element(featureless.size(), [&](std::size_t i) {
        const Triangle& t = mesh.triangles[i];
        const auto is_flat = [&](std::uint32_t v) { return cosines[v] >= kFlatCosine; };
        const auto bends_less = [&](double cosine) {  // but at sharp edges
            return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
                return cosines[v] >= cosine || is_sharp(cosines[v]);
            });
        };
        const double size = longest_squared(mesh.positions, t);
        featureless[i] = shapes[i] != FaceShape::Curved ||
                         std::all_of(t.begin(), t.end(), is_flat) ||
                         (size > kLong * kLong && bends_less(kFlatCosine)) ||
                         (size > kVeryLong * kVeryLong && bends_less(kGentleCosine));
    });
    return featureless;
}

}  // namespace laplacian_lines
