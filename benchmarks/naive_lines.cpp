// SPDX-License-Identifier: GPL-3.0-or-later
#include "naive_lines.h"

#include <cmath>

namespace benchmarks {

using namespace laplacian_lines;

NaiveLines::NaiveLines(const PlainMesh& mesh, const std::vector<Eigen::Vector3f>& vectors)
    : mesh_(mesh), vectors_(vectors), values_(mesh.positions.size()) {}

void NaiveLines::extract(const View& view, std::vector<Eigen::Vector3f>& segments) {
    segments.clear();
    const Eigen::Vector3f eye = view.eye.cast<float>();
    const float w = float(view.w);
    for (std::size_t v = 0; v < values_.size(); ++v)
        values_[v] = vectors_[v].dot(eye - w * mesh_.positions[v]);
    for (const Triangle& t : mesh_.triangles)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if ((values_[a] < 0) == (values_[b] < 0)) continue;
            const float s = values_[a] / (values_[a] - values_[b]);
            segments.push_back((1 - s) * mesh_.positions[a] + s * mesh_.positions[b]);
        }
}

}  // namespace benchmarks
