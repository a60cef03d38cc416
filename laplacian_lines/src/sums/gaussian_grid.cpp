// SPDX-License-Identifier: GPL-3.0-or-later
// The sums over all vertices q, for every vertex p, that Eq. 2 of the paper needs,
//     Σ m w exp(−|q − p|²/4h) times 1, n_q and q − p,   w = facing_weight(n_q·n_p) or 1,
// on a grid, slab by slab along its longest axis:
//  1. Spread: each mass times monomials of its normal (normal_moments.h) goes to the nodes around
//     it, 4 x 4 x 4, by cubic B-splines.
//  2. Convolve the nodes along x, y and z (grid_convolution.h) with the filter of spline_kernel().
//  3. Interpolate at each vertex, and take the gradient, from 5 x 5 x 5 nodes, by quartic splines.
//  4. Contract these moments with the normal at p, which gives the first two sums; the third is 2h
//     times the gradient of the first.
#include "sums/gaussian_sums.h"

#include <algorithm>
#include <cmath>

#include "sums/grid_convolution.h"
#include "sums/normal_moments.h"
#include "sums/summation_cost.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace {

constexpr double kPi = EIGEN_PI;
constexpr int kFrequencies = 512;  // at which K is sampled: taps reach less than that
constexpr int kAliases = 4;        // to either side: others are below 1e-7 of the sums

/// Fourier transform of the B-spline of a degree.
double spline_transform(double w, int degree) {
    return std::pow(std::sin(w / 2) / (w / 2), degree + 1);
}

/// K(w), w in radians a cell.
double influence(double w, double sigma) {
    double spread_aliases = 0, value_aliases = 0;
    for (int m = -kAliases; m <= kAliases; ++m) {
        spread_aliases += std::pow(spline_transform(w + 2 * kPi * m, 3), 2);
        value_aliases += std::pow(spline_transform(w + 2 * kPi * m, 4), 2);
    }
    const double gaussian = sigma * std::sqrt(2 * kPi) * std::exp(-sigma * sigma * w * w / 2);
    return gaussian * spline_transform(w, 3) * spline_transform(w, 4) /
           (spread_aliases * value_aliases);
}

/// The filter that goes from nodes, onto which cubic B-splines have spread masses, to values half a
/// cell further on, from which quartic B-splines interpolate Σ m exp(−x²/2σ²). σ in cells.
/// Symmetric: tap j, 0 <= j < count, is for nodes at the distance j + 1/2.
/// Spreading by a spline of degree 3 multiplies the spectrum of the masses by that spline's
/// transform U₃(w), and the nodes repeat it at all w + 2πm, its aliases; interpolation multiplies
/// by U₄ at every alias. The filter K has to make up for both. The one whose error is least, on
/// average over all places of the nodes, is the optimal influence function of R. W. Hockney and J.
/// W. Eastwood, "Computer Simulation Using Particles", section 8-3, along one axis:
///     K(w) = G(w) U₃(w) U₄(w) / (Σ_m U₃(w + 2πm)² · Σ_m U₄(w + 2πm)²),
/// with the Gaussian's transform G, whose own aliases are small. Taps are its inverse transform.
std::vector<double> spline_kernel(double sigma, int count) {
    std::vector<double> taps(std::size_t(count), 0);
    for (int f = 0; f < kFrequencies; ++f) {
        const double w = kPi * (f + 0.5) / kFrequencies;
        const double value = influence(w, sigma) / kFrequencies;
        for (int j = 0; j < count; ++j)
            taps[std::size_t(j)] += value * std::cos((j + 0.5) * w);
    }
    return taps;
}

/// Nodes to each side of a value half way between two of them; size: √h in cells.
int tap_count(double size, const GridResolution& resolution) {
    return int(std::ceil(resolution.cutoff * size + 0.5));
}

/// spline_kernel() as a row, as GridConvolution takes it: the tap at d from the middle one goes
/// from node i to the value half a cell after node i − d.
std::vector<float> kernel_taps(double size, const GridResolution& resolution, int reach) {
    const int count = tap_count(size, resolution), middle = kBlock * reach + kBlock - 1;
    const std::vector<double> half = spline_kernel(std::sqrt(2.0) * size, count);
    std::vector<float> taps(std::size_t(2 * middle + 1), 0.f);
    for (int i = 0; i < count; ++i)
        taps[std::size_t(middle + i + 1)] = taps[std::size_t(middle - i)] =
            float(half[std::size_t(i)]);
    return taps;
}

void clear(GridNode* nodes, int count) {
    for (int node = 0; node < count; ++node)
        std::fill(std::begin(nodes[node].moments), std::end(nodes[node].moments), 0.f);
}

/// Calls visit(node of the box, node of the block) for the first of four nodes along x of the part
/// of a box that lies in a block, see GridGeometry::step_to().
template <class Visit>
void for_each_row(int part, Visit visit) {
    const int first = (((part >> 2) * kBox + (part >> 1 & 1)) * kBox + (part & 1)) * kBlock;
    for (int row = 0; row < kBlock * kBlock; ++row)
        visit(first + (row / kBlock * kBox + row % kBlock) * kBox, row * kBlock);
}

/// One sum, in the steps above.
class GridSum {
public:
    GridSum(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
            const GaussianKernel& kernel, const GridResolution& resolution, GaussianSums& sums)
        : mesh_(mesh),
          normals_(normals),
          size_(kernel.size),
          facing_(kernel.facing),
          sums_(sums),
          grid_(mesh.positions, resolution.cell * size_),
          points_(grid_, mesh.positions),
          reach_((tap_count(size_ / grid_.cell, resolution) + kBlock - 1) / kBlock),
          convolution_(grid_, points_.reached(), reach_,
                       kernel_taps(size_ / grid_.cell, resolution, reach_)) {}

    /// A slab is done once `reach` more have been spread; its points are read one slab later, for
    /// their splines reach into the next.
    void run(const StageProgress& stage) {
        const int slabs = grid_.blocks[2];
        make_room(0);
        for (int slab = 0; slab <= slabs + reach_; ++slab) {
            stage.report(double(slab) / (slabs + reach_ + 1));
            if (slab < slabs) {
                make_room(slab + 1);
                spread_points(slab);
            }
            convolution_.add_slab(slab, masses_[slab % 2]);
            if (slab >= reach_ && slab - reach_ < slabs) convolution_.finish_slab(slab - reach_);
            if (slab > reach_) interpolate_points(slab - reach_ - 1);
        }
    }

private:
    using Nodes = std::vector<GridNode>;

    std::size_t block(int slab, std::size_t site) const {
        return std::size_t(slab) * grid_.sites() + site;
    }

    /// Prepares the masses of a slab, to which its points and those of the slab before contribute.
    void make_room(int slab) {
        BlockSlab& masses = masses_[slab % 2];
        masses.allocate(grid_.sites(), [&](std::size_t site) {
            return slab < grid_.blocks[2] && points_.reached()[block(slab, site)];
        });
        in_parallel(masses.sites().size(),
                    [&](std::size_t i) { clear(masses.block(masses.sites()[i]), kBlockNodes); });
    }

    /// The place in the point's cell, and the first node it reaches in the box of its block.
    std::size_t locate(std::uint32_t point, CellPlace& place) const {
        const Eigen::Vector3d p = grid_.in_cells(mesh_.positions[point]);
        std::size_t node = 0;
        for (int axis = 2; axis >= 0; --axis) {
            const int cell = int(p[axis]);
            place.t[axis] = p[axis] - cell;
            node = node * kBox + std::size_t(cell - 2) % kBlock;
        }
        place.t[3] = 0;
        return node;
    }

    /// In parallel for every second block along x and y, since their boxes do not overlap.
    void spread_points(int slab) {
        const auto row = std::size_t(grid_.blocks[0] + 1) / 2,
                   rows = std::size_t(grid_.blocks[1] + 1) / 2;
        for (std::size_t turn = 0; turn < 4; ++turn)
            in_parallel<Nodes>(row * rows, [&](std::size_t i, Nodes& nodes) {
                const std::size_t x = 2 * (i % row) + turn % 2, y = 2 * (i / row) + turn / 2;
                if (x < std::size_t(grid_.blocks[0]) && y < std::size_t(grid_.blocks[1]))
                    spread_block(slab, y * std::size_t(grid_.blocks[0]) + x, nodes);
            });
    }

    void spread_block(int slab, std::size_t site, Nodes& nodes) {
        const auto begin = points_.begin(block(slab, site)), end = points_.end(block(slab, site));
        if (begin == end) return;
        GridNode* const box = grow(nodes, kBoxNodes);
        clear(box, kBoxNodes);
        // The cubic splines' first node is the second one.
        GridNode* const second = box + (kBox + 1) * kBox + 1;
        for (auto p = begin; p < end; ++p) {
            CellPlace place;
            GridNode value;
            set_moments(mesh_.masses[*p], normals_[*p], value);
            const std::size_t corner = locate(*p, place);
            loops_.spread(value, place, second + corner);
        }
        for (int part = 0; part < 8; ++part)
            add_part(part, box,
                     masses_[(slab + (part >> 2)) % 2].block(site + grid_.step_to(part & 3)));
    }

    static void add_part(int part, const GridNode* box, GridNode* nodes) {
        for_each_row(part, [&](int in_box, int in_block) {
            for (int k = 0; k < kBlock; ++k)
                for (int i = 0; i < 2 * kMoments; ++i)
                    nodes[in_block + k].moments[i] += box[in_box + k].moments[i];
        });
    }

    void fill_box(int slab, std::size_t site, GridNode* box) const {
        for (int part = 0; part < 8; ++part) {
            const GridNode* nodes =
                convolution_.result(slab + (part >> 2)).block(site + grid_.step_to(part & 3));
            for_each_row(part, [&](int in_box, int in_block) {
                std::copy_n(nodes + in_block, kBlock, box + in_box);
            });
        }
    }

    void interpolate_points(int slab) {
        in_parallel<Nodes>(grid_.sites(), [&](std::size_t site, Nodes& nodes) {
            const auto begin = points_.begin(block(slab, site)),
                       end = points_.end(block(slab, site));
            if (begin == end) return;
            GridNode* const box = grow(nodes, kBoxNodes);
            fill_box(slab, site, box);
            for (auto p = begin; p < end; ++p)
                write(*p, box);
        });
    }

    void write(std::uint32_t p, const GridNode* box) const {
        CellPlace place;
        PointSums sums;
        loops_.interpolate(box + locate(p, place), place, sums);
        const ContractedMoments at = contract(sums, normals_[p], facing_);
        // ∇ exp(−|q − p|²/4h) is (q − p)/(2h) times it.
        const double to_moment = 2 * size_ * size_ / grid_.cell;
        sums_.mass[p] = float(at.mass);
        for (int axis = 0; axis < 3; ++axis)
            sums_.first_moment[p][grid_.axes[axis]] = float(to_moment * at.gradient[axis]);
        sums_.normal_difference[p] = (at.normal - at.mass * normals_[p]).cast<float>();
    }

    const PreparedMesh& mesh_;
    const std::vector<Eigen::Vector3d>& normals_;
    const double size_;  // √h
    const bool facing_;
    GaussianSums& sums_;
    const GridGeometry grid_;
    const GridPoints points_;
    const GridLoops& loops_ = fastest<GridLoops>();
    const int reach_;  // of the convolution, in blocks
    GridConvolution convolution_;
    BlockSlab masses_[2];  // of slab l at l % 2
};

}  // namespace

GaussianSums grid_sums(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                       const GaussianKernel& kernel, const GridResolution& resolution,
                       const StageProgress& stage) {
    GaussianSums sums(mesh.size());
    GridSum(mesh, normals, kernel, resolution, sums).run(stage);
    return sums;
}

}  // namespace laplacian_lines
