// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/gaussian_sums.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>

#include "sums/grid_convolution.h"
#include "sums/grid_points.h"
#include "sums/grid_slabs.h"
#include "sums/normal_moments.h"
#include "sums/size_band.h"
#include "system/simd_sets.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kChunk = 512;  // points that are worked on at once

struct Chunk {
    std::uint32_t site;
    const std::uint32_t *begin, *end;
    RowMask rows[8];  // by part of the box, see clear_rows(): those it spreads to
};

/// In blocks, of the convolution with the band's largest kernel.
int reach(const SizeBand& band, const GridGeometry& grid, const GridResolution& resolution) {
    const int taps = tap_count(band.nodes().back() / grid.cell, resolution);
    return (taps + kBlock - 1) / kBlock;
}

/// For the targets of one band of kernel sizes; see docs/algorithms.md.
template <class Real, int Groups>
class GridSum {
    using Node = GridNode<Real, Groups>;
    using Slab = BlockSlab<Node>;

public:
    GridSum(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
            const GridGeometry& grid, const GridPoints& points, const SizeBand& band,
            const GridResolution& resolution, const GaussianKernel& kernel, GaussianSums& sums)
        : mesh_(mesh),
          normals_(normals),
          grid_(grid),
          points_(points),
          band_(band),
          kernel_(kernel),
          sums_(sums),
          reach_(reach(band, grid, resolution)) {
        for (double size : band.nodes())
            levels_.emplace_back(grid, points.target_nodes(), reach_,
                                 kernel_taps<Real>(size / grid.cell, resolution, reach_));
    }

    void run(const StageProgress& stage) {
        const int slabs = grid_.blocks[2];
        for (int slab = 0; slab <= slabs + reach_; ++slab) {
            stage.report(double(slab) / (slabs + reach_ + 1));
            if (slab < slabs) {
                spread_points(slab);
                merge_boxes(slab);
            }
            for (GridConvolution<Real, Groups>& level : levels_) {
                level.add_slab(slab, masses_);
                if (slab >= reach_ && slab - reach_ < slabs) level.finish_slab(slab - reach_);
            }
            if (slab > reach_) interpolate_points(slab - reach_ - 1);
        }
    }

private:
    /// What the points of a slab's blocks spread, chunk by chunk.
    struct SpreadSlab {
        std::vector<Chunk> chunks;
        std::vector<std::uint32_t> first_chunk;  // [sites + 1]
        NodeBuffer<Node> boxes;                  // kBoxNodes a chunk
    };

    std::size_t block(int slab, std::size_t site) const {
        return std::size_t(slab) * grid_.sites() + site;
    }

    void list_chunks(int slab, std::vector<Chunk>& chunks) const {
        chunks.clear();
        for (std::size_t c = 0; c < grid_.sites(); ++c) {
            const std::uint32_t* end = points_.end(block(slab, c));
            for (const std::uint32_t* p = points_.begin(block(slab, c)); p < end; p += kChunk)
                chunks.push_back({std::uint32_t(c), p, std::min(p + kChunk, end), {}});
        }
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

    void spread_points(int slab) {
        SpreadSlab& s = spread_[slab % 2];
        list_chunks(slab, s.chunks);
        s.first_chunk.assign(grid_.sites() + 1, 0);
        for (const Chunk& chunk : s.chunks)
            ++s.first_chunk[chunk.site + 1];
        for (std::size_t c = 1; c < s.first_chunk.size(); ++c)
            s.first_chunk[c] += s.first_chunk[c - 1];
        s.boxes.grow(s.chunks.size() * kBoxNodes);
        in_parallel(s.chunks.size(), [&](std::size_t i) {
            Chunk& chunk = s.chunks[i];
            spread_chunk(chunk, points_.first_nodes(block(slab, chunk.site)),
                         s.boxes.get() + i * kBoxNodes);
        });
    }

    void spread_chunk(Chunk& chunk, BlockMask first_nodes, Node* box) const {
        BlockMask nodes[8] = {};
        kSpreadNodes.visit_all(first_nodes, [&](int part, BlockMask mask) { nodes[part] |= mask; });
        for (int part = 0; part < 8; ++part) {
            chunk.rows[part] = rows_of(nodes[part], 0);
            loops_.clear_rows(part, chunk.rows[part], box);
        }
        // The cubic splines' first node is the second one.
        Node* const second = box + (kBox + 1) * kBox + 1;
        for (const std::uint32_t* p = chunk.begin; p < chunk.end; ++p) {
            CellPlace place;
            Node value;
            set_moments(mesh_.masses[*p], normals_[*p], value);
            const std::size_t corner = locate(*p, place);
            loops_.spread(value, place, second + corner);
        }
    }

    /// Adds up the boxes that overlap each block of a slab, always in the same order.
    void merge_boxes(int slab) {
        const auto& masks = points_.source_nodes();
        masses_.masks().assign(masks.begin() + std::ptrdiff_t(block(slab, 0)),
                               masks.begin() + std::ptrdiff_t(block(slab + 1, 0)));
        masses_.allocate();
        const std::size_t row = std::size_t(grid_.blocks[0]);
        in_parallel(masses_.sites().size(), [&](std::size_t i) {
            const std::size_t site = masses_.sites()[i];
            Node* nodes = masses_.block(site);
            std::memset(static_cast<void*>(nodes), 0, sizeof(Node) * kBlockNodes);
            for (int part = 0; part < 8; ++part) {
                const std::size_t step = std::size_t(part & 1) + row * std::size_t(part >> 1 & 1);
                if (step > site || slab < part >> 2) continue;
                const SpreadSlab& s = spread_[(slab - (part >> 2)) % 2];
                for (std::uint32_t c = s.first_chunk[site - step];
                     c < s.first_chunk[site - step + 1]; ++c)
                    loops_.add_rows(part, s.chunks[c].rows[part], s.boxes.get() + c * kBoxNodes,
                                    nodes);
            }
        });
    }

    void fill_box(const GridConvolution<Real, Groups>& level, int slab, std::size_t site,
                  Node* box) const {
        for (int part = 0; part < 8; ++part) {
            const std::size_t other = site + std::size_t(part & 1) +
                                      std::size_t(grid_.blocks[0]) * std::size_t(part >> 1 & 1);
            if (other >= grid_.sites()) continue;
            const Slab& z = level.result(slab + (part >> 2));
            loops_.copy_rows(part, rows_of(z.mask(other), 0), z.block(other), box);
        }
    }

    void interpolate_points(int slab) {
        list_chunks(slab, chunks_);
        in_parallel<NodeBuffer<Node>>(chunks_.size(), [&](std::size_t i, NodeBuffer<Node>& buffer) {
            const Chunk& chunk = chunks_[i];
            Node* boxes = buffer.grow(kBoxNodes * levels_.size());
            for (std::size_t j = 0; j < levels_.size(); ++j)
                fill_box(levels_[j], slab, chunk.site, boxes + j * kBoxNodes);
            for (const std::uint32_t* p = chunk.begin; p < chunk.end; ++p)
                if (band_.contains(kernel_.kernel_sizes[*p])) write(*p, boxes);
        });
    }

    void write(std::uint32_t p, const Node* boxes) const {
        CellPlace place;
        const std::size_t corner = locate(p, place);
        ContractedMoments total{0, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
        double weights[SizeBand::kMaxNodes];
        band_.weights(kernel_.kernel_sizes[p], weights);
        for (std::size_t j = 0; j < levels_.size(); ++j) {
            PointSums<Real, Groups> sums;
            loops_.interpolate(boxes + j * kBoxNodes + corner, place, sums);
            const ContractedMoments at = contract(sums, normals_[p]);
            // The Gaussian's derivative is (q − p)/(2h) times it.
            const double size = band_.nodes()[j], to_moment = 2 * size * size / grid_.cell;
            total.mass += weights[j] * at.mass;
            total.normal += weights[j] * at.normal;
            for (int axis = 0; axis < 3; ++axis)
                total.gradient[grid_.axes[axis]] += weights[j] * to_moment * at.gradient[axis];
        }
        sums_.mass[p] = float(total.mass);
        sums_.first_moment[p] = total.gradient.cast<float>();
        sums_.normal_difference[p] = (total.normal - total.mass * normals_[p]).cast<float>();
    }

    const PreparedMesh& mesh_;
    const std::vector<Eigen::Vector3d>& normals_;
    const GridGeometry& grid_;
    const GridPoints& points_;
    const SizeBand& band_;
    const GridLoops<Real, Groups>& loops_ = fastest<GridLoops<Real, Groups>>();
    const GaussianKernel& kernel_;
    GaussianSums& sums_;
    const int reach_;
    std::vector<GridConvolution<Real, Groups>> levels_;
    SpreadSlab spread_[2];
    Slab masses_;
    std::vector<Chunk> chunks_;
};

template <class Real, int Groups>
void sum_bands(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
               const GaussianKernel& kernel, const GridResolution& resolution,
               const StageProgress& stage, GaussianSums& sums) {
    const std::vector<SizeBand> bands = size_bands(kernel.kernel_sizes, resolution.band_nodes);
    for (std::size_t b = 0; b < bands.size(); ++b) {
        const GridGeometry grid(mesh.positions, resolution.cell * bands[b].nodes().front());
        GridPoints points(grid, mesh.positions);
        if (bands.size() > 1) {
            std::vector<bool> is_target(mesh.size());
            for (std::size_t v = 0; v < mesh.size(); ++v)
                is_target[v] = bands[b].contains(kernel.kernel_sizes[v]);
            points.restrict_to_targets(grid, mesh.positions, is_target,
                                       1 + reach(bands[b], grid, resolution));
        }
        GridSum<Real, Groups>(mesh, normals, grid, points, bands[b], resolution, kernel, sums)
            .run(
                stage.part(double(b) / double(bands.size()), double(b + 1) / double(bands.size())));
    }
}

}  // namespace

GaussianSums grid_sums(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                       const GaussianKernel& kernel, const GridResolution& resolution,
                       const StageProgress& stage) {
    GaussianSums sums(mesh.size());
    const bool doubles = resolution.doubles;
    const auto facing = doubles ? sum_bands<double, 2> : sum_bands<float, 2>;
    const auto plain = doubles ? sum_bands<double, 1> : sum_bands<float, 1>;
    (kernel.facing ? facing : plain)(mesh, normals, kernel, resolution, stage, sums);
    return sums;
}

}  // namespace laplacian_lines
