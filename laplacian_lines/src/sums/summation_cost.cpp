// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/summation_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "laplacian_lines/error.h"
#include "sums/grid_points.h"

namespace laplacian_lines {
namespace {

// Measured on a processor with AVX-512; the ratios are about the same with AVX2.
constexpr double kPerLeafPair = 0.45;  // 32 x 32 pairs, of which many are beyond the cutoff
constexpr double kQuick = 0.52;        // times that cost, with quick Gaussians
constexpr double kPerVertex = 0.26;    // spreading and interpolating
constexpr double kPerNode = 0.135;     // one tap, per cell of the surface's area
constexpr std::size_t kSampledLeaves = 64;
// At most so many blocks, and a million more: tables take about 6 bytes a block.
constexpr double kBlocksPerVertex = 8;

constexpr double kLeastTurn = 0.01;  // radians; below, on planes, Δn is about 0

constexpr double kCostly = 3e7;  // half a minute on one thread of that processor

double grid_cost(const PreparedMesh& mesh, const GaussianKernel& kernel,
                 const GridResolution& resolution) {
    const double cell = resolution.cell * kernel.size, vertices = double(mesh.size());
    if (!resolution.is_exact ||
        GridGeometry(mesh.positions, cell).block_count() > kBlocksPerVertex * vertices + 1e6)
        return std::numeric_limits<double>::infinity();
    const double area = sum_of(mesh.size(), [&](std::size_t v) { return mesh.masses[v]; });
    const double taps = 2 * resolution.cutoff / resolution.cell;
    return kPerVertex * vertices + kPerNode * taps * area / (cell * cell);
}

}  // namespace

GridResolution grid_resolution(double accuracy, double normal_turn) {
    const double turn = std::clamp(normal_turn, kLeastTurn, 1.0);
    GridResolution resolution;
    // The largest error on the test meshes is 1.1e-3 cell^4.9 / turn down to cells of 0.7 √h and
    // falls more slowly below: 1.4e-3 cell^4.7 / turn bounds both, which reference_test.cpp checks.
    // Cells over 1.25 √h save nothing, for spreading and interpolating cost the same.
    resolution.cell = std::min(1.25, std::pow(accuracy * turn / 1.4e-3, 1 / 4.7));
    // The share of the second moment along an axis beyond the cutoff is at most .2 accuracies.
    resolution.cutoff = 6.3 - 0.85 * std::log10(accuracy / 1e-3);
    // The sum for Δn is turn² of that of masses, which carries a rounding error of 3e-7. Where
    // turn is about 0, no more than the default accuracy can be reached.
    resolution.is_exact = accuracy >= 1e-3 || accuracy * turn * turn >= 6e-7;
    return resolution;
}

SummationCosts summation_costs(const PreparedMesh& mesh, const SpatialTree& tree,
                               const GaussianKernel& kernel, const GridResolution& resolution) {
    const double speed = kernel.quick ? kQuick : 1;
    return {speed * pairs_cost(tree, kernel.cutoff * kernel.size),
            grid_cost(mesh, kernel, resolution)};
}

double pairs_cost(const SpatialTree& tree, double radius) {
    const auto& leaves = tree.leaves();
    const std::size_t step = std::max<std::size_t>(1, leaves.size() / kSampledLeaves);
    double pairs = 0, sampled = 0;
    for (std::size_t i = step / 2; i < leaves.size(); i += step) {
        tree.visit_leaves(leaves[i].box, radius, [&](const SpatialTree::Leaf&) { ++pairs; });
        ++sampled;
    }
    return kPerLeafPair * pairs * double(leaves.size()) / sampled;
}

void refuse_costly_sum(double cost, const char* advice) {
    if (cost < kCostly) return;
    refuse("The mesh has too many vertices near each other to be finished within minutes. " +
               std::string(advice),
           ErrorCode::TooCostly);
}

}  // namespace laplacian_lines
