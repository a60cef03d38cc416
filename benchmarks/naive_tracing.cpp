// SPDX-License-Identifier: GPL-3.0-or-later
#include "naive_tracing.h"

namespace benchmarks {

using namespace laplacian_lines;

NaiveTracing::NaiveTracing(const PlainMesh& mesh, const std::vector<Eigen::Vector3f>& vectors)
    : mesh_(mesh), vectors_(vectors), values_(mesh.positions.size()) {}

void NaiveTracing::extract(const View& view, std::vector<Eigen::Vector3f>& points,
                           std::vector<std::uint32_t>& starts) {
    points.clear();
    starts.clear();
    crossings_.clear();
    const Eigen::Vector3f eye = view.eye.cast<float>();
    const float w = float(view.w);
    for (std::size_t v = 0; v < values_.size(); ++v)
        values_[v] = vectors_[v].dot(eye - w * mesh_.positions[v]);
    const auto zero_between = [&](std::uint32_t low, std::uint32_t high) -> Eigen::Vector3f {
        const float s = values_[low] / (values_[low] - values_[high]);
        return (1 - s) * mesh_.positions[low] + s * mesh_.positions[high];
    };
    for (const Triangle& t : mesh_.triangles) {
        std::uint32_t ends[2];
        int found = 0;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if ((values_[a] < 0) != (values_[b] < 0))
                ends[found++] = crossings_.on_edge(a, b, zero_between);
        }
        if (found == 2) crossings_.join(ends[0], ends[1]);
    }
    crossings_.for_each_line([&] { starts.push_back(std::uint32_t(points.size())); },
                             [&](const Eigen::Vector3f& point) { points.push_back(point); });
}

}  // namespace benchmarks
