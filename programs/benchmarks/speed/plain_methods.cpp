// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_methods.h"

namespace benchmarks {
PlainMesh::PlainMesh(const laplacian_lines::TriangleMesh& mesh) : triangles(mesh.triangles) {
    positions.reserve(mesh.positions.size());
    for (const Eigen::Vector3d& p : mesh.positions)
        positions.push_back(p.cast<float>());
}

void PlainLines::evaluate(const laplacian_lines::View& view) {
    const Eigen::Vector3f eye = view.eye.cast<float>();
    const float w = float(view.w);
    for (std::size_t v = 0; v < values_.size(); ++v)
        values_[v] = vectors_[v].dot(eye - w * mesh_.positions[v]);
}

Eigen::Vector3f PlainLines::zero_between(std::uint32_t a, std::uint32_t b) const {
    const float s = values_[a] / (values_[a] - values_[b]);
    return (1 - s) * mesh_.positions[a] + s * mesh_.positions[b];
}

void PlainLines::extract(const laplacian_lines::View& view,
                         std::vector<Eigen::Vector3f>& segments) {
    segments.clear();
    evaluate(view);
    for (const laplacian_lines::Triangle& t : mesh_.triangles)
        for (int k = 0; k < 3; ++k)
            if (const std::uint32_t a = t[k], b = t[(k + 1) % 3]; is_crossed(a, b))
                segments.push_back(zero_between(a, b));
}

}  // namespace benchmarks
