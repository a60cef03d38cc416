// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "field/tensor_slopes.h"
#include "laplacian_lines/field.h"
#include "mesh/prepared_mesh.h"
#include "mesh/spatial_tree.h"

namespace laplacian_lines {

/// The vertices of a mesh with their S as sources for sum_tensors(), leaf by leaf of its tree.
class TensorSources {
public:
    TensorSources(const PreparedMesh& mesh, const SpatialTree& tree, const Field& field);

    /// Writes what is within `reach` of the leaf's box, places as seen from the box's centre, and
    /// returns how many there are. `sources` grows as needed.
    std::size_t collect(const SpatialTree::Leaf& leaf, double reach,
                        std::vector<TensorSource>& sources) const;

private:
    const SpatialTree& tree_;
    std::vector<TensorLeaf> packed_;
};

}  // namespace laplacian_lines
