// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/coarseness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "laplacian_lines/line_visibility.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// In D: about two pixels of a picture of 400.
constexpr double kFarthestContour = 0.006;
constexpr double kLargestRoughTriangle = 0.06;  // whose contours are smooth on rough meshes, D
constexpr double kLeastCoarsePatch = 0.03;      // diagonal of its box, D
// Clean scans have up to 0.3 or, with many small forms, 1; those with noise of 20 % of the edges
// 0.8 and more, and so do terraces.
constexpr double kLargestRoughness = 0.8;
// As far as the smoothing of normals reaches.
constexpr int kRings = 2;
constexpr double kSquaredCosineOfRings = 0.9925;  // of 5°

/// Squares of cosines between a triangle's plane and normals; 0 from 90° on.
struct Lean {
    double squared_size;  ///< of the longest edge, local
    double of_corner;     ///< the one that leans most
    double of_mean;
};

Lean lean_of(const PreparedMesh& mesh, const Field& field, const Triangle& t) {
    const Eigen::Vector3d corners[3] = {mesh.positions[t[0]], mesh.positions[t[1]],
                                        mesh.positions[t[2]]};
    const Eigen::Vector3d u = corners[1] - corners[0], v = corners[2] - corners[0];
    const Eigen::Vector3d plane = u.cross(v);
    const auto squared_cosine = [&](const Eigen::Vector3d& n) {
        const double cosine = n.dot(plane), squares = plane.squaredNorm() * n.squaredNorm();
        return cosine > 0 && squares > 0 ? cosine * cosine / squares : 0;
    };
    Lean lean{std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()}), 1, 0};
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t corner : t) {
        const Eigen::Vector3d n = field.normals[mesh.original_vertex[corner]].cast<double>();
        lean.of_corner = std::min(lean.of_corner, squared_cosine(n));
        sum += n;
    }
    lean.of_mean = squared_cosine(sum);
    return lean;
}

bool is_larger(const Lean& lean, double size) {
    return lean.squared_size > size * size;
}

bool is_coarse(const Lean& lean) {
    return is_larger(lean, kLargestSmoothTriangle) ||
           lean.squared_size * (1 - lean.of_corner) > kFarthestContour * kFarthestContour;
}

/// The patches of coarse triangles that share vertices.
class CoarsePatches {
public:
    CoarsePatches(const PreparedMesh& mesh, const std::vector<std::uint8_t>& coarse)
        : mesh_(mesh), parent_(mesh.size()), boxes_(mesh.size()) {
        std::iota(parent_.begin(), parent_.end(), 0u);
        for (std::size_t i = 0; i < coarse.size(); ++i)
            if (coarse[i]) join(mesh.triangles[i]);
    }
    bool is_small(std::size_t triangle) {
        return boxes_[root(mesh_.triangles[triangle][0])].diagonal().norm() < kLeastCoarsePatch;
    }

private:
    std::uint32_t root(std::uint32_t v) {
        while (parent_[v] != v)
            v = parent_[v] = parent_[parent_[v]];
        return v;
    }
    void join(const Triangle& t) {
        const std::uint32_t first = root(t[0]);
        for (const std::uint32_t v : t) {
            const std::uint32_t other = root(v);
            parent_[other] = first;
            boxes_[first].extend(boxes_[other]);
            boxes_[first].extend(mesh_.positions[v]);
        }
    }

    const PreparedMesh& mesh_;
    std::vector<std::uint32_t> parent_;       // by vertex
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
                coarse[i] = lean_of(mesh, field, t).of_mean < kSquaredCosineOfRings;
        });
    }
}

}  // namespace

bool is_rough(const MeshReport& report) {
    return report.roughness > kLargestRoughness;
}

std::vector<std::uint8_t> find_coarse_triangles(const PreparedMesh& mesh, const Field& field) {
    std::vector<std::uint8_t> coarse(mesh.triangles.size());
    const bool only_large = is_rough(field.report);
    for_each_element(coarse.size(), [&](std::size_t i) {
        const Lean lean = lean_of(mesh, field, mesh.triangles[i]);
        coarse[i] = only_large ? is_larger(lean, kLargestRoughTriangle) : is_coarse(lean);
    });
    const auto has_coarse = [&] {
        return std::find(coarse.begin(), coarse.end(), 1) != coarse.end();
    };
    if (!has_coarse()) return coarse;
    CoarsePatches patches(mesh, coarse);
    for (std::size_t i = 0; i < coarse.size(); ++i)
        coarse[i] = coarse[i] && !patches.is_small(i);
    if (has_coarse()) grow_patches(mesh, field, coarse);
    return coarse;
}

}  // namespace laplacian_lines
