// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/field_steps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "laplacian_lines/precompute_options.h"
#include "mesh/flat_faces.h"
#include "sums/summation_cost.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr std::size_t kSamples = 1024;
// Standard deviations are 0.8, 1.6, 3.2 mean edges: each Gaussian is the next one's fourth power.
constexpr double kWidest = 3.2;
constexpr double kReach = 2.2 * kWidest;
// In D: coarser meshes are not measured.
constexpr double kLargestEdge = 0.025;
// Lower quartile of the angles between normals and the mean around them, radians: the mesh is
// smooth below the first, may be rough above the second.
constexpr double kSmooth = 0.01, kRough = 0.03;
// Terraces start to count at the first and count in full from the second on; clean meshes have up
// to 1.1.
constexpr double kLeastTerraces = 1.2, kClearTerraces = 1.5;
// Noise in mean edges starts to count at the first and counts in full from the second on. Then
// sigma is 1.5 times its root: .47, .67 and .95 mean edges for .1, .2 and .4, the best on scans and
// coarse forms.
constexpr double kLeastNoise = 0.04, kClearNoise = 0.08, kSigmaOfRoot = 1.5;
// In mean edges: sigma is proportional to the roughness, the best for terraces.
constexpr double kLargestSigma = 2.5, kSigmaOfRoughness = 0.7;
constexpr double kLongest = 1e4;  // in units of pairs_cost(): a tenth of a second

/// From 0 at `none` to 1 at `all`.
double ramp(double x, double none, double all) {
    return std::clamp((x - none) / (all - none), 0., 1.);
}

/// Angles of a normal's turn: unsmoothed to the first scale, and from each scale to the next.
using Turns = std::array<double, 3>;

Turns turns_at(const PreparedMesh& mesh, const SpatialTree& tree,
               const std::vector<Eigen::Vector3d>& normals, std::size_t i, double unit) {
    const Eigen::Vector3d &p = mesh.positions[i], &n = normals[i];
    const double reach = kReach * unit, falloff = 0.5 / (kWidest * kWidest * unit * unit);
    std::array<Eigen::Vector3d, 4> means = {n, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                            Eigen::Vector3d::Zero()};
    tree.visit_leaves(Eigen::AlignedBox3d(p), reach, [&](const SpatialTree::Leaf& leaf) {
        for (std::uint32_t q = leaf.begin; q < leaf.end; ++q) {
            const double squared = (mesh.positions[q] - p).squaredNorm();
            if (squared > reach * reach) continue;
            const Eigen::Vector3d weighted =
                mesh.masses[q] * facing_weight(normals[q].dot(n)) * normals[q];
            const double widest = std::exp(-falloff * squared);
            const double middle = widest * widest * widest * widest;
            means[3] += widest * weighted;
            means[2] += middle * weighted;
            means[1] += middle * middle * middle * middle * weighted;
        }
    });
    Turns turns;
    for (std::size_t k = 1; k < means.size(); ++k) {
        means[k] = means[k].stableNormalized();
        turns[k - 1] = (means[k] - means[k - 1]).norm();
    }
    return turns;
}

/// The lower quartile of the turns at one scale: noise is the same everywhere, so it shows where
/// the form is flat.
double lower_quartile(std::vector<Turns>& turns, std::size_t scale) {
    const auto place = turns.begin() + std::ptrdiff_t((turns.size() - 1) / 4);
    std::nth_element(turns.begin(), place, turns.end(),
                     [scale](const Turns& a, const Turns& b) { return a[scale] < b[scale]; });
    return (*place)[scale];
}

double roughness_by_scales(const PreparedMesh& mesh, const SpatialTree& tree,
                           const std::vector<float>& relative_sizes,
                           const std::vector<Eigen::Vector3d>& normals) {
    const std::size_t count = std::min(kSamples, mesh.size());
    if (mesh.mean_edge > kLargestEdge) return 0;
    if (pairs_cost(tree, kReach * mesh.mean_edge) * double(count) / double(mesh.size()) > kLongest)
        return 0;
    std::vector<Turns> turns(count);
    in_parallel(count, [&](std::size_t sample) {
        const std::size_t i = sample * mesh.size() / count;
        turns[sample] =
            turns_at(mesh, tree, normals, i, mesh.mean_edge * double(relative_sizes[i]));
    });
    const double from_triangles = lower_quartile(turns, 0);
    const double finer = lower_quartile(turns, 1), coarser = lower_quartile(turns, 2);
    return coarser > 0 ? ramp(from_triangles, kSmooth, kRough) * finer / coarser : 0;
}

}  // namespace

double measure_roughness(const PreparedMesh& mesh, const VertexRanges& ranges,
                         const SpatialTree& tree, const std::vector<float>& relative_sizes,
                         const std::vector<Eigen::Vector3d>& normals, const StageProgress& stage) {
    const double noise = vertex_noise(mesh, ranges, normals, stage);
    const double terraces = roughness_by_scales(mesh, tree, relative_sizes, normals);
    const double of_noise =
        kSigmaOfRoot / kSigmaOfRoughness * std::sqrt(noise) * ramp(noise, kLeastNoise, kClearNoise);
    const double of_terraces = terraces * ramp(terraces, kLeastTerraces, kClearTerraces);
    if (of_noise == 0 && of_terraces == 0) return 0;
    const CornerTable sides(mesh.triangles, mesh.size());
    // Noisy meshes have no flat faces, while small features of CAD meshes look like noise. Where
    // all vertices are on edges, as of plates, the form turns their normals as terraces would.
    const FlatFaces flat = flat_faces(mesh, sides);
    if (flat.are_large()) return 0;
    return flat.is_cad_mesh() ? of_terraces : std::max(of_noise, of_terraces);
}

double automatic_normal_sigma(double roughness) {
    return std::min(kSigmaOfRoughness * roughness, kLargestSigma);
}

}  // namespace laplacian_lines
