// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

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
    std::uint32_t crossing(std::uint32_t a, std::uint32_t b);
    void follow(std::uint32_t first, std::vector<Eigen::Vector3f>& points);

    static constexpr std::uint32_t kNone = 0xffffffffu;
    struct Crossing {
        Eigen::Vector3f position;
        std::uint32_t neighbours[2] = {kNone, kNone};
        bool visited = false;
    };

    const PlainMesh& mesh_;
    const std::vector<Eigen::Vector3f>& vectors_;
    std::vector<float> values_;
    std::unordered_map<std::uint64_t, std::uint32_t> crossing_of_edge_;
    std::vector<Crossing> crossings_;
};

}  // namespace benchmarks
