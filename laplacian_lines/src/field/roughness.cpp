// SPDX-License-Identifier: GPL-3.0-or-later
// How much normals have to be smoothed. Two things make a mesh rough, and neither is its form:
//  1. Noise, which vertex_noise() measures in mean edges.
//  2. Terraces of segmented volumes, flat steps that are several edges wide. Take the mean of the
//     normals around a vertex under Gaussians of .8, 1.6 and 3.2 mean edges. From the first to the
//     second mean, the normal turns by what the terraces do; from the second to the third, by what
//     the form does. Terraces are the ratio of these two turns.
// What clean meshes have of either does not count, see ramp(). Roughness is the larger of the two,
// in units in which sigma, the deviation of the smoothing, is proportional to it.
//
// Limits are fitted: to twenty meshes of 5,000 to 870,000 triangles, clean, decimated, and with
// noise of 10, 20 and 40 % of the edges; and to heads from marching cubes, from densities and from
// labels (tests/meshes/generators.h), whose lines should agree (tests/core/roughness_test.cpp).
#include "field/field_steps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sums/summation_cost.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// ---- terraces ----

// Enough for a quartile that is right to 3 % of the ranks.
constexpr std::size_t kSamples = 1024;
// Deviation of the widest Gaussian, mean edges. It is cut where a tenth is left of it, for speed.
constexpr double kWidest = 3.2, kReach = 2.2 * kWidest;
// In D. On coarser meshes the widest Gaussian reaches over .18 of D, where forms turn as well.
constexpr double kLargestEdge = 0.025;
// Radians to the narrowest mean, of which a quarter of the normals has less: the mesh is smooth
// below the first, may have terraces from the second on.
constexpr double kSmooth = 0.01, kRough = 0.03;
// Clean meshes have up to 1.07, terraces 1.54 to 3.06.
constexpr double kLeastTerraces = 1.2, kClearTerraces = 1.5;
// As pairs_cost() has it, but ten times as slow here: a tenth of a second. More is not measured.
constexpr double kLongest = 1e4;

// ---- noise ----

// In mean edges: clean and decimated meshes have .03 at most, noise of 10 % of the edges .06 to .1.
constexpr double kLeastNoise = 0.04, kClearNoise = 0.08;

// ---- sigma ----

// In mean edges. Of terraces it is .7 times the ratio: with that, lines of heads from labels are as
// long as those of heads from densities. 2.5 is over what the roughest of them needs, 2.1.
constexpr double kSigmaOfRoughness = 0.7, kLargestSigma = 2.5;
// Of noise it is 1.5 times the root: .47, .67 and .95 mean edges for .1, .2 and .4 gave the lines
// nearest those of the clean mesh.
constexpr double kSigmaOfRoot = 1.5;

/// From 0 at `none` to 1 at `all`.
double ramp(double x, double none, double all) {
    return std::clamp((x - none) / (all - none), 0., 1.);
}

/// Angles, as chords, between a vertex's normal and the mean under the narrowest Gaussian, and from
/// each mean to the next.
using Turns = std::array<double, 3>;

Turns turns_at(const PreparedMesh& mesh, const SpatialTree& tree,
               const std::vector<Eigen::Vector3d>& normals, std::size_t i) {
    const Eigen::Vector3d &p = mesh.positions[i], &n = normals[i];
    const double reach = kReach * mesh.mean_edge, widest_sigma = kWidest * mesh.mean_edge,
                 falloff = 0.5 / (widest_sigma * widest_sigma);
    std::array<Eigen::Vector3d, 4> means = {n, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                            Eigen::Vector3d::Zero()};
    tree.visit_leaves(Eigen::AlignedBox3d(p), reach, [&](const SpatialTree::Leaf& leaf) {
        for (std::uint32_t q = leaf.begin; q < leaf.end; ++q) {
            const double squared = (mesh.positions[q] - p).squaredNorm();
            if (squared > reach * reach) continue;
            const Eigen::Vector3d weighted =
                mesh.masses[q] * facing_weight(normals[q].dot(n)) * normals[q];
            // half the deviation is the fourth power
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

/// The ratio of turns, less where even unsmoothed normals hardly turn; 0 if it is not measured, as
/// on coarse meshes or where too many vertices are near each other.
double measure_terraces(const PreparedMesh& mesh, const SpatialTree& tree,
                        const std::vector<Eigen::Vector3d>& normals) {
    const std::size_t count = std::min(kSamples, mesh.size());
    if (mesh.mean_edge > kLargestEdge) return 0;
    if (pairs_cost(tree, kReach * mesh.mean_edge) * double(count) / double(mesh.size()) > kLongest)
        return 0;
    std::vector<Turns> turns(count);
    in_parallel(count, [&](std::size_t sample) {
        turns[sample] = turns_at(mesh, tree, normals, sample * mesh.size() / count);
    });
    const double from_triangles = lower_quartile(turns, 0);
    const double finer = lower_quartile(turns, 1), coarser = lower_quartile(turns, 2);
    return coarser > 0 ? ramp(from_triangles, kSmooth, kRough) * finer / coarser : 0;
}

}  // namespace

double measure_roughness(const PreparedMesh& mesh, const VertexRanges& ranges,
                         const SpatialTree& tree, const std::vector<Eigen::Vector3d>& normals,
                         const StageProgress& stage) {
    if (mesh.origin == Origin::Design || mesh.origin == Origin::FineDesign) return 0;
    const double terraces = measure_terraces(mesh, tree, normals);
    const double of_terraces = terraces * ramp(terraces, kLeastTerraces, kClearTerraces);
    // noise leaves no flat faces
    if (mesh.origin == Origin::Voxels) return of_terraces;
    const double noise = vertex_noise(mesh, ranges, normals, stage);
    return std::max(of_terraces, kSigmaOfRoot / kSigmaOfRoughness * std::sqrt(noise) *
                                     ramp(noise, kLeastNoise, kClearNoise));
}

double automatic_normal_sigma(double roughness) {
    return std::min(kSigmaOfRoughness * roughness, kLargestSigma);
}

}  // namespace laplacian_lines
