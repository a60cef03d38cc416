// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/summation_cost.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>

#include "laplacian_lines/error.h"
#include "sums/grid_points.h"
#include "sums/size_band.h"

namespace laplacian_lines {
namespace {

// Measured on a processor with AVX-512; the ratios are about the same with AVX2.
constexpr double kPerLeafPair = 0.45;  // 32 x 32 pairs, of which many are beyond the cutoff
constexpr double kQuick = 0.52;        // times that cost, with quick Gaussians
constexpr double kPerVertex = 0.26;    // to spread and to interpolate
constexpr double kPerNode = 0.135;     // one tap for every cell of the surface's area
constexpr double kDoubles = 2.2;       // times the cost of floats
constexpr double kOneGroup = 0.6;      // times the cost of two groups of moments
constexpr std::size_t kSampledLeaves = 64;
// Tables take 20 bytes a block.
constexpr double kBlocksPerVertex = 8;

constexpr double kEndless = 3e7;  // half a minute

/// `radius_at(v)`: how far vertex v looks.
template <class RadiusAt>
double direct_cost(const SpatialTree& tree, RadiusAt radius_at) {
    const auto& leaves = tree.leaves();
    const std::size_t step = std::max<std::size_t>(1, leaves.size() / kSampledLeaves);
    double pairs = 0, sampled = 0;
    for (std::size_t i = step / 2; i < leaves.size(); i += step) {
        tree.visit_leaves(leaves[i].box, radius_at(leaves[i].begin),
                          [&](const SpatialTree::Leaf&) { ++pairs; });
        ++sampled;
    }
    return kPerLeafPair * pairs * double(leaves.size()) / sampled;
}

double grid_cost(const PreparedMesh& mesh, const GaussianKernel& kernel,
                 const GridResolution& resolution) {
    double cost = 0;
    for (const SizeBand& band : size_bands(kernel.kernel_sizes, resolution.band_nodes)) {
        const double cell = resolution.cell * band.nodes().front();
        if (GridGeometry(mesh.positions, cell).block_count() >
            kBlocksPerVertex * double(mesh.size()) + 1e6)
            return std::numeric_limits<double>::infinity();
        double vertices = 0, area = 0;
        for (std::size_t v = 0; v < mesh.size(); ++v)
            if (band.contains(kernel.kernel_sizes[v])) {
                vertices += 1;
                area += mesh.masses[v];
            }
        const double levels = double(band.nodes().size());
        const double taps = 2 * resolution.cutoff * band.nodes().back() / cell;
        // Half of the work on vertices is spreading, which all levels share.
        cost += kPerVertex * vertices * (1 + levels) / 2;
        cost += kPerNode * levels * taps * area / (cell * cell);
    }
    return cost * (kernel.facing ? 1 : kOneGroup) * (resolution.doubles ? kDoubles : 1);
}

}  // namespace

SummationCosts summation_costs(const PreparedMesh& mesh, const SpatialTree& tree,
                               const GaussianKernel& kernel, const GridResolution& resolution) {
    const auto radius = [&](std::uint32_t v) { return kernel.cutoff * kernel.kernel_sizes[v]; };
    const double speed = kernel.quick ? kQuick : 1;
    return {speed * direct_cost(tree, radius), grid_cost(mesh, kernel, resolution)};
}

double pairs_cost(const SpatialTree& tree, double radius) {
    return direct_cost(tree, [&](std::uint32_t) { return radius; });
}

void refuse_endless_sum(double cost, const char* advice) {
    if (cost < kEndless) return;
    throw Error(ErrorCode::TooCostly,
                std::string("The mesh has too many vertices near each other to be finished within "
                            "minutes. ") +
                    advice);
}

}  // namespace laplacian_lines
