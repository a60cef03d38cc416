// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "joined_crossings.h"
#include "laplacian_lines/view.h"
#include "plain_mesh.h"

namespace benchmarks {

/// What the extractor is compared with: the zero crossings of Δn·l in one loop over the triangles,
/// each found once an edge through a hash map and joined to lines. Nothing is filtered.
class NaiveTracing {
public:
    /// Both have to outlive this object. `vectors` are the Δn of the vertices.
    NaiveTracing(const PlainMesh& mesh, const std::vector<Eigen::Vector3f>& vectors);

    /// Replaces `points` by the lines' points and `starts` by the first point of each line.
    void extract(const laplacian_lines::View& view, std::vector<Eigen::Vector3f>& points,
                 std::vector<std::uint32_t>& starts);

private:
    const PlainMesh& mesh_;
    const std::vector<Eigen::Vector3f>& vectors_;
    std::vector<float> values_;
    JoinedCrossings<Eigen::Vector3f> crossings_;
};

}  // namespace benchmarks
