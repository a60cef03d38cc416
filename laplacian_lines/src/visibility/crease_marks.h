// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "laplacian_lines/line_set.h"
#include "system/on_demand.h"
#include "visibility/sight_mesh.h"
#include "visibility/vertex_places.h"

namespace laplacian_lines {

/// Edges of the mesh that are edges of the form, by edge; empty if there are none.
using CreaseMarks = std::vector<std::uint8_t>;

/// Finds the edges of a mesh along lines. Thread-safe.
class CreaseMarker {
public:
    /// The mesh has to outlive it.
    explicit CreaseMarker(const SightMesh& mesh) : mesh_(mesh) {}

    /// The edges between successive points of the creases among the lines. What is not an edge is
    /// left out.
    CreaseMarks mark(const std::vector<LineSet>& lines) const;

private:
    void find_along(const Eigen::Vector3d& begin, const Eigen::Vector3d& end,
                    std::vector<std::uint32_t>& edges) const;
    const VertexPlaces& places() const;

    const SightMesh& mesh_;
    mutable OnDemand<std::unique_ptr<const VertexPlaces>> places_;
};

}  // namespace laplacian_lines
