// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/coarseness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "field/field_steps.h"
#include "system/disjoint_sets.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// In D: about two pixels of a picture of 400.
constexpr double kFarthestContour = 0.006;
constexpr double kLargestSmoothTriangle = 0.03;  // longest edge, D
constexpr double kLargestRoughTriangle = 0.06;   // whose contours are smooth on rough meshes, D
constexpr double kLeastCoarsePatch = 0.03;       // diagonal of its box, D
constexpr double kSquaredCosineOfMade = 0.9698;  // of 10°
// As far as the smoothing of normals reaches.
constexpr int kRings = 2;
constexpr double kSquaredCosineOfRings = 0.9925;  // of 5°

constexpr double kFlat = 0.9999984769132877;   // least cosine: of 0.1°
constexpr double kSharp = 0.7660444431189781;  // most cosine: of 40°
constexpr double kLong = 0.02;                 // D

/// A triangle's plane against normals: squared cosines, 0 from 90° on.
class Lean {
public:
    Lean(const PreparedMesh& mesh, const Field& field, const Triangle& t) {
        const Eigen::Vector3d u = mesh.positions[t[1]] - mesh.positions[t[0]];
        const Eigen::Vector3d v = mesh.positions[t[2]] - mesh.positions[t[0]];
        plane_ = u.cross(v);
        squared_size_ = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
        for (int k = 0; k < 3; ++k)
            normals_[k] = field.normals[mesh.original_vertex[t[k]]].cast<double>();
    }
    bool is_larger(double size) const { return squared_size_ > size * size; }  // longest edge
    bool is_coarse() const {
        return is_larger(kLargestSmoothTriangle) ||
               squared_size_ * (1 - of_corners()) > kFarthestContour * kFarthestContour;
    }
    /// Steeper than facets of round forms do.
    bool leans_at_corner() const { return of_corners() < kSquaredCosineOfMade; }
    double of_mean() const { return squared_cosine(normals_[0] + normals_[1] + normals_[2]); }

private:
    /// The one that leans most.
    double of_corners() const {
        return std::min({squared_cosine(normals_[0]), squared_cosine(normals_[1]),
                         squared_cosine(normals_[2])});
    }
    double squared_cosine(const Eigen::Vector3d& n) const {
        const double cosine = n.dot(plane_), squares = plane_.squaredNorm() * n.squaredNorm();
        return cosine > 0 && squares > 0 ? cosine * cosine / squares : 0;
    }

    Eigen::Vector3d plane_;  // its normal, as long as twice the area
    Eigen::Vector3d normals_[3];
    double squared_size_;
};

/// The patches of coarse triangles that share vertices.
class CoarsePatches {
public:
    CoarsePatches(const PreparedMesh& mesh, const std::vector<std::uint8_t>& coarse)
        : mesh_(mesh), sets_(mesh.size()), boxes_(mesh.size()) {
        for (std::size_t i = 0; i < coarse.size(); ++i)
            if (coarse[i]) join(mesh.triangles[i]);
    }
    bool is_small(std::size_t triangle) {
        return boxes_[sets_.root(mesh_.triangles[triangle][0])].diagonal().norm() <
               kLeastCoarsePatch;
    }

private:
    void join(const Triangle& t) {
        for (const std::uint32_t v : t) {
            Eigen::AlignedBox3d box = boxes_[sets_.root(t[0])].merged(boxes_[sets_.root(v)]);
            boxes_[sets_.unite(t[0], v)] = box.extend(mesh_.positions[v]);
        }
    }

    const PreparedMesh& mesh_;
    DisjointSets sets_;                       // of vertices
    std::vector<Eigen::AlignedBox3d> boxes_;  // by root
};

/// Beside a sharp edge the normals of flat triangles lean as well, if less, all to one side: what
/// faces the eye would change three times there. On a curved surface they lean to all sides.
void grow_patches(const PreparedMesh& mesh, const Field& field, std::vector<std::uint8_t>& coarse) {
    for (int ring = 0; ring < kRings; ++ring) {
        std::vector<std::uint8_t> touched(mesh.size(), 0);
        for (std::size_t i = 0; i < coarse.size(); ++i)
            if (coarse[i])
                for (const std::uint32_t v : mesh.triangles[i])
                    touched[v] = 1;
        for_each_element(coarse.size(), [&](std::size_t i) {
            const Triangle& t = mesh.triangles[i];
            if (!coarse[i] && (touched[t[0]] || touched[t[1]] || touched[t[2]]))
                coarse[i] = Lean(mesh, field, t).of_mean() < kSquaredCosineOfRings;
        });
    }
}

/// Where contours change between edges and smooth curves they are drawn twice or have gaps, since
/// the two are apart. Of a mesh that is mostly coarse all of them follow edges.
void unite_majority(std::vector<std::uint8_t>& coarse) {
    const auto count = std::size_t(std::count(coarse.begin(), coarse.end(), 1));
    if (2 * count > coarse.size()) std::fill(coarse.begin(), coarse.end(), 1);
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

double longest_squared(const PreparedMesh& mesh, const Triangle& t) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest,
                           (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).squaredNorm());
    return longest;
}

}  // namespace

bool is_rough(const MeshReport& report) {
    return report.roughness > kLargestRoughness;
}

std::vector<std::uint8_t> find_coarse_triangles(const PreparedMesh& mesh, bool is_made,
                                                const Field& field) {
    std::vector<std::uint8_t> coarse(mesh.triangles.size());
    const bool only_large = is_rough(field.report), made = !only_large && is_made;
    for_each_element(coarse.size(), [&](std::size_t i) {
        const Lean lean(mesh, field, mesh.triangles[i]);
        coarse[i] = only_large ? lean.is_larger(kLargestRoughTriangle)
                               : lean.is_coarse() || (made && lean.leans_at_corner());
    });
    const auto has_coarse = [&] {
        return std::find(coarse.begin(), coarse.end(), 1) != coarse.end();
    };
    if (!has_coarse()) return coarse;
    CoarsePatches patches(mesh, coarse);
    for (std::size_t i = 0; i < coarse.size(); ++i)
        coarse[i] = coarse[i] && (made || !patches.is_small(i));
    if (has_coarse()) grow_patches(mesh, field, coarse);
    unite_majority(coarse);
    return coarse;
}

std::vector<std::uint8_t> find_plain_triangles(const PreparedMesh& mesh) {
    std::vector<std::uint8_t> plain(mesh.triangles.size(), 0);
    const std::vector<double> cosines = least_cosines(mesh);
    const auto is_sharp = [&](double cosine) { return cosine <= kSharp; };
    if (std::none_of(cosines.begin(), cosines.end(), is_sharp)) return plain;
    for_each_element(plain.size(), [&](std::size_t i) {
        const Triangle& t = mesh.triangles[i];
        const auto is_flat = [&](std::uint32_t v) { return cosines[v] >= kFlat; };
        const auto is_clear = [&](std::uint32_t v) { return is_flat(v) || is_sharp(cosines[v]); };
        plain[i] =
            std::all_of(t.begin(), t.end(), is_flat) ||
            (std::all_of(t.begin(), t.end(), is_clear) && longest_squared(mesh, t) > kLong * kLong);
    });
    return plain;
}

}  // namespace laplacian_lines
