// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "mesh/prepared_mesh.h"
#include "mesh/spatial_tree.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Positions of the points of a leaf, relative to the centre of its box; unused ones are 0.
struct LeafPlaces {
    using Row = Eigen::Array<float, SpatialTree::kLeafSize, 1>;
    Row axes[3] = {Row::Zero(), Row::Zero(), Row::Zero()};
};

/// Writes the numbers of those of the first `count` positions that, moved by `shift`, are at most
/// √squared_reach from a box around the origin; returns how many.
std::size_t find_near(const LeafPlaces& places, std::size_t count, const Eigen::Vector3f& shift,
                      const Eigen::Vector3f& half_size, float squared_reach,
                      std::uint32_t near[SpatialTree::kLeafSize]);

/// The vertices of a mesh, sorted by the tree, as sources of sums for all vertices of a leaf at
/// once. A Source has a position x, y, z in floats, relative to the leaf's centre, so that numbers
/// are small.
template <class Source>
class LeafSources {
public:
    /// `source_of(v)`: without the position.
    template <class SourceOf>
    LeafSources(const PreparedMesh& mesh, const SpatialTree& tree, SourceOf source_of)
        : tree_(tree),
          sources_(large_array<Source>(mesh.size())),
          places_(large_array<LeafPlaces>(tree.leaves().size())) {
        in_parallel(places_.size(), [&](std::size_t i) {
            const SpatialTree::Leaf& leaf = tree.leaves()[i];
            LeafPlaces& to = places_[i];
            for (std::uint32_t v = leaf.begin; v < leaf.end; ++v) {
                const Eigen::Vector3f p = (mesh.positions[v] - leaf.box.center()).cast<float>();
                Source& source = sources_[v] = source_of(v);
                source.x = p.x(), source.y = p.y(), source.z = p.z();
                for (int k = 0; k < 3; ++k)
                    to.axes[k][v - leaf.begin] = p[k];
            }
        });
    }

    /// Writes those within `reach` of the leaf's box; returns how many. `sources` grows as needed.
    std::size_t collect(const SpatialTree::Leaf& leaf, double reach,
                        std::vector<Source>& sources) const {
        const Eigen::Vector3d centre = leaf.box.center();
        const Eigen::Vector3f half_size = (leaf.box.sizes() / 2).cast<float>();
        std::size_t count = 0;
        tree_.visit_leaves(leaf.box, reach, [&](const SpatialTree::Leaf& other) {
            std::uint32_t near[SpatialTree::kLeafSize];
            const Eigen::Vector3f shift = (other.box.center() - centre).cast<float>();
            const std::size_t found =
                find_near(places_[std::size_t(&other - tree_.leaves().data())],
                          other.end - other.begin, shift, half_size, float(reach * reach), near);
            if (sources.size() < count + found) sources.resize(2 * (count + found));
            for (std::size_t i = 0; i < found; ++i) {
                Source& source = sources[count++] = sources_[other.begin + near[i]];
                source.x += shift.x(), source.y += shift.y(), source.z += shift.z();
            }
        });
        return count;
    }

private:
    const SpatialTree& tree_;
    std::vector<Source> sources_;
    std::vector<LeafPlaces> places_;
};

}  // namespace laplacian_lines
