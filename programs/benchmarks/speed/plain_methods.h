// SPDX-License-Identifier: GPL-3.0-or-later
// Plain methods to compare with: one thread, nothing filtered.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

namespace benchmarks {

/// As programs hold a mesh for drawing, in floats.
struct PlainMesh {
    explicit PlainMesh(const laplacian_lines::TriangleMesh& mesh);

    std::vector<Eigen::Vector3f> positions;
    std::vector<laplacian_lines::Triangle> triangles;
};

/// All zeros of Δn·l (or of n·l: contours) in one loop over the triangles.
class PlainLines {
public:
    /// Both outlive this. `vectors` are Δn, or n, of the vertices.
    PlainLines(const PlainMesh& mesh, const std::vector<Eigen::Vector3f>& vectors)
        : mesh_(mesh), vectors_(vectors), values_(mesh.positions.size()) {}

    /// Replaces `segments` by pairs of points.
    void extract(const laplacian_lines::View& view, std::vector<Eigen::Vector3f>& segments);

private:
    void evaluate(const laplacian_lines::View& view);
    bool is_crossed(std::uint32_t a, std::uint32_t b) const {
        return (values_[a] < 0) != (values_[b] < 0);
    }
    Eigen::Vector3f zero_between(std::uint32_t a, std::uint32_t b) const;
    const PlainMesh& mesh_;
    const std::vector<Eigen::Vector3f>& vectors_;
    std::vector<float> values_;
};

}  // namespace benchmarks
