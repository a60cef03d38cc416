// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "clusters/cluster_data.h"
#include "laplacian_lines/field.h"

namespace laplacian_lines {

/// Values of a vertex as clusters hold them, local.
struct LocalVertex {
    Eigen::Vector3d position, normal;
    ShapeOperator shape_operator;  ///< S·D
};

VertexRecord make_record(const LocalVertex& v);

/// Writes the bounds of a cluster of these vertices at a place of a group.
void write_facing_bounds(const std::vector<LocalVertex>& values, FacingBounds& bounds,
                         std::size_t place);

}  // namespace laplacian_lines
