// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "laplacian_lines/line_set.h"
#include "system/on_demand.h"
#include "visibility/vertex_lookup.h"
#include "visibility/visibility_mesh.h"

namespace laplacian_lines {

/// Edges of the mesh that are edges of the form, by edge; empty if there are none.
using CreaseMarks = std::vector<std::uint8_t>;

/// Finds the edges of a mesh, which outlives this, along lines. Thread-safe.
class CreaseMarker {
public:
    explicit CreaseMarker(const VisibilityMesh& mesh) : mesh_(mesh) {}

    /// Marks the edges between successive points of the creases among the lines. Caches the last
    /// result, since views of one mesh have the same creases.
    std::shared_ptr<const CreaseMarks> mark(const std::vector<LineSet>& lines) const;

private:
    using Segment = std::array<Eigen::Vector3d, 2>;  // mesh coordinates

    CreaseMarks mark(const std::vector<Segment>& creases) const;
    void find_along(const Eigen::Vector3d& begin, const Eigen::Vector3d& end,
                    std::vector<std::uint32_t>& edges) const;
    const VertexLookup& places() const;

    const VisibilityMesh& mesh_;
    mutable OnDemand<std::unique_ptr<const VertexLookup>> places_;
    mutable std::mutex mutex_;
    mutable std::vector<Segment> creases_;
    mutable std::shared_ptr<const CreaseMarks> marks_ = std::make_shared<const CreaseMarks>();
};

}  // namespace laplacian_lines
