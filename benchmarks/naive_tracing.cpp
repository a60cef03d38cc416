// SPDX-License-Identifier: GPL-3.0-or-later
#include "naive_tracing.h"

#include <algorithm>

namespace benchmarks {

using namespace laplacian_lines;

NaiveTracing::NaiveTracing(const PlainMesh& mesh, const std::vector<Eigen::Vector3f>& vectors)
    : mesh_(mesh), vectors_(vectors), values_(mesh.positions.size()) {}

std::uint32_t NaiveTracing::crossing(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [found, is_new] = crossing_of_edge_.try_emplace(std::uint64_t(low) << 32 | high,
                                                               std::uint32_t(crossings_.size()));
    if (is_new) {
        const float s = values_[low] / (values_[low] - values_[high]);
        crossings_.push_back({(1 - s) * mesh_.positions[low] + s * mesh_.positions[high]});
    }
    return found->second;
}

void NaiveTracing::follow(std::uint32_t first, std::vector<Eigen::Vector3f>& points) {
    for (std::uint32_t before = kNone, here = first; here != kNone;) {
        Crossing& c = crossings_[here];
        points.push_back(c.position);
        if (c.visited) return;  // once round
        c.visited = true;
        const std::uint32_t next = c.neighbours[c.neighbours[0] == before ? 1 : 0];
        before = here;
        here = next;
    }
}

void NaiveTracing::extract(const View& view, std::vector<Eigen::Vector3f>& points,
                           std::vector<std::uint32_t>& starts) {
    points.clear();
    starts.clear();
    crossings_.clear();
    crossing_of_edge_.clear();
    const Eigen::Vector3f eye = view.eye.cast<float>();
    const float w = float(view.w);
    for (std::size_t v = 0; v < values_.size(); ++v)
        values_[v] = vectors_[v].dot(eye - w * mesh_.positions[v]);
    for (const Triangle& t : mesh_.triangles) {
        std::uint32_t ends[2];
        int found = 0;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if ((values_[a] < 0) != (values_[b] < 0)) ends[found++] = crossing(a, b);
        }
        if (found != 2) continue;
        for (int k = 0; k < 2; ++k) {
            auto& neighbours = crossings_[ends[k]].neighbours;
            neighbours[neighbours[0] == kNone ? 0 : 1] = ends[1 - k];
        }
    }
    for (bool loops : {false, true})
        for (std::uint32_t c = 0; c < crossings_.size(); ++c)
            if (!crossings_[c].visited && (loops || crossings_[c].neighbours[1] == kNone)) {
                starts.push_back(std::uint32_t(points.size()));
                follow(c, points);
            }
}

}  // namespace benchmarks
