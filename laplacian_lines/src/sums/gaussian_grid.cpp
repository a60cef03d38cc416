// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/gaussian_sums.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sums/grid_convolution.h"
#include "sums/summation_cost.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace {

// ---- moments ----
//
// Σ m w(n_q·n_p) and Σ m w(n_q·n_p) n_q for any n_p, w = 1 or facing_weight(), from moments Σ m
// n_x^i n_y^j n_z^k that do not depend on p. The first group of 16 has degrees 0, 1 and 3; the
// second has degree 4, from which degree 2 follows since |n| = 1.

// Moments of degree 3, from the fifth of the first group on.
enum { kXXX, kYYY, kZZZ, kXXY, kXXZ, kXYY, kYYZ, kXZZ, kYZZ, kXYZ, kCubic };
constexpr double kEntries[kCubic] = {1, 1, 1, 3, 3, 3, 3, 3, 3, 6};
constexpr int kFirstCubic = 4;

// Order of the moments of degree 4, the second group.
enum {
    kXXXX,
    kYYYY,
    kZZZZ,
    kXXXY,
    kXXXZ,
    kXYYY,
    kYYYZ,
    kXZZZ,
    kYZZZ,
    kXXYY,
    kXXZZ,
    kYYZZ,
    kXXYZ,
    kXYYZ,
    kXYZZ
};
// The axis with an odd number of factors in a moment of degree 3; 3: none.
constexpr int kOddAxis[kCubic] = {0, 1, 2, 1, 2, 0, 2, 0, 1, 3};
// Moments of degree 4 that are x, y and z times those of degree 3.
constexpr int kTimes[3][kCubic] = {
    {kXXXX, kXYYY, kXZZZ, kXXXY, kXXXZ, kXXYY, kXYYZ, kXXZZ, kXYZZ, kXXYZ},
    {kXXXY, kYYYY, kYZZZ, kXXYY, kXXYZ, kXYYY, kYYYZ, kXYZZ, kYYZZ, kXYYZ},
    {kXXXZ, kYYYZ, kZZZZ, kXXYZ, kXXZZ, kXYYZ, kYYZZ, kXZZZ, kYZZZ, kXYZZ}};

void cubic_monomials(const Eigen::Vector3d& n, double cubic[kCubic]) {
    const double x = n.x(), y = n.y(), z = n.z(), xx = x * x, yy = y * y, zz = z * z;
    const double values[kCubic] = {x * xx, y * yy, z * zz, xx * y, xx * z,
                                   x * yy, yy * z, x * zz, y * zz, x * y * z};
    for (int i = 0; i < kCubic; ++i)
        cubic[i] = values[i];
}

double dot(const double* a, const float* b, int count) {
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += a[i] * double(b[i]);
    return sum;
}

void set_moments(double mass, const Eigen::Vector3d& normal, GridNode& node) {
    const Eigen::Vector3d mn = mass * normal;
    double cubic[kCubic];
    cubic_monomials(normal, cubic);
    float* t = node.moments;
    t[0] = float(mass), t[1] = float(mn.x()), t[2] = float(mn.y()), t[3] = float(mn.z());
    for (int i = 0; i < kCubic; ++i)
        t[kFirstCubic + i] = float(mass * cubic[i]);
    t[14] = t[15] = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < kCubic; ++i)
            t[kMoments + kTimes[axis][i]] = float(mn[axis] * cubic[i]);
    t[2 * kMoments - 1] = 0;
}

/// Sums around p, for its normal.
struct ContractedMoments {
    double mass = 0;           ///< Σ m w
    Eigen::Vector3d normal;    ///< Σ m w n_q
    Eigen::Vector3d gradient;  ///< of the mass, as the derivatives in `sums`
};

/// `facing`: w = facing_weight(), else 1.
ContractedMoments contract(const PointSums& sums, const Eigen::Vector3d& n, bool facing) {
    const float* t = sums.moments;
    const Eigen::Vector3d first(t[1], t[2], t[3]);
    if (!facing)
        return {t[0], first,
                Eigen::Vector3d(sums.derivatives[0][0], sums.derivatives[1][0],
                                sums.derivatives[2][0])};
    // w(c) = 1/2 + 3/4 c - 1/4 c^3, c = n_q·n_p; powers of c contract moments with n_p. c n_q =
    // c n_q |n_q|² has degree 4, too.
    double cubic[kCubic], weights[kFirstCubic + kCubic], normal_weights[kCubic];
    const double linear[4] = {0.75 * n.x(), 0.75 * n.y(), 0.75 * n.z(), 0};
    cubic_monomials(n, cubic);
    weights[0] = 0.5;
    for (int axis = 0; axis < 3; ++axis)
        weights[1 + axis] = linear[axis];
    for (int i = 0; i < kCubic; ++i) {
        weights[kFirstCubic + i] = -0.25 * kEntries[i] * cubic[i];
        normal_weights[i] = weights[kFirstCubic + i] + linear[kOddAxis[i]];
    }
    ContractedMoments result;
    result.mass = dot(weights, t, kFirstCubic + kCubic);
    for (int axis = 0; axis < 3; ++axis) {
        result.normal[axis] = 0.5 * first[axis];
        for (int i = 0; i < kCubic; ++i)
            result.normal[axis] += normal_weights[i] * double(t[kMoments + kTimes[axis][i]]);
        result.gradient[axis] = dot(weights, sums.derivatives[axis], kFirstCubic + kCubic);
    }
    return result;
}

// ---- kernel ----

constexpr double kPi = 3.14159265358979323846;
constexpr int kFrequencies = 512;
constexpr int kAliases = 4;

/// Fourier transform.
double spline_transform(double w, int degree) {
    return std::pow(std::sin(w / 2) / (w / 2), degree + 1);
}

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

/// The filter from masses spread by cubic B-splines to values half a cell further on from which
/// quartic B-splines interpolate Σ m exp(−x²/2σ²); σ in cells. Symmetric: tap j, 0 <= j < count, is
/// for nodes at the distance j + 1/2. The optimal influence function of Hockney and Eastwood,
/// section 8-3, along one axis.
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

/// spline_kernel() as a row: taps[size / 2 + d] goes from node i to the value half a cell after
/// node i − d. Zero-padded to whole blocks.
std::vector<float> kernel_taps(double size, const GridResolution& resolution, int reach) {
    const int count = tap_count(size, resolution), middle = kBlock * reach + kBlock - 1;
    const std::vector<double> half = spline_kernel(std::sqrt(2.0) * size, count);
    std::vector<float> taps(std::size_t(2 * middle + 1), 0.f);
    for (int i = 0; i < count; ++i)
        taps[std::size_t(middle + i + 1)] = taps[std::size_t(middle - i)] =
            float(half[std::size_t(i)]);
    return taps;
}

// ---- sums ----

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

/// See docs/algorithms.md.
class GridSum {
public:
    GridSum(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
            const GaussianKernel& kernel, const GridResolution& resolution, GaussianSums& sums)
        : mesh_(mesh),
          normals_(normals),
          size_(double(kernel.kernel_sizes.front())),
          facing_(kernel.facing),
          sums_(sums),
          grid_(mesh.positions, resolution.cell * size_),
          points_(grid_, mesh.positions),
          reach_((tap_count(size_ / grid_.cell, resolution) + kBlock - 1) / kBlock),
          convolution_(grid_, points_.reached(), reach_,
                       kernel_taps(size_ / grid_.cell, resolution, reach_)) {}

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
        // The Gaussian's derivative is (q − p)/(2h) times it.
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
