// SPDX-License-Identifier: GPL-3.0-or-later
// What the core is compared with: each as one would write it down, on one thread, nothing filtered.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

namespace benchmarks {

/// Δn by Belkin's operator: vertices in the cells of a regular grid of the kernel's cutoff (6.1 √h,
/// accuracy 1e-3), double precision, no corrections.
std::vector<Eigen::Vector3d> plain_belkin(const laplacian_lines::TriangleMesh& mesh,
                                          const std::vector<Eigen::Vector3f>& normals,
                                          double kernel_size);

/// A mesh as programs hold it for drawing, in floats.
struct PlainMesh {
    explicit PlainMesh(const laplacian_lines::TriangleMesh& mesh);

    std::vector<Eigen::Vector3f> positions;
    std::vector<laplacian_lines::Triangle> triangles;
};

/// All zero crossings of Δn·l (or of n·l: contours) in one loop over the triangles.
class PlainLines {
public:
    /// Both have to outlive this object. `vectors` are Δn, or n, of the vertices.
    PlainLines(const PlainMesh& mesh, const std::vector<Eigen::Vector3f>& vectors)
        : mesh_(mesh), vectors_(vectors), values_(mesh.positions.size()) {}

    /// Replaces `segments` by pairs of points, not joined.
    void extract(const laplacian_lines::View& view, std::vector<Eigen::Vector3f>& segments);

    /// Replaces `points` by the points of lines, each found once an edge through a hash map, and
    /// `starts` by the first point of each line.
    void trace(const laplacian_lines::View& view, std::vector<Eigen::Vector3f>& points,
               std::vector<std::uint32_t>& starts);

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    struct Crossing {
        Eigen::Vector3f point;
        std::uint32_t neighbours[2] = {kNone, kNone};
        bool visited = false;
    };

    void evaluate(const laplacian_lines::View& view);
    bool is_crossed(std::uint32_t a, std::uint32_t b) const {
        return (values_[a] < 0) != (values_[b] < 0);
    }
    Eigen::Vector3f zero_between(std::uint32_t a, std::uint32_t b) const;
    std::uint32_t crossing_on(std::uint32_t a, std::uint32_t b);
    void join(std::uint32_t a, std::uint32_t b);
    void follow(std::uint32_t first, std::vector<Eigen::Vector3f>& points);

    const PlainMesh& mesh_;
    const std::vector<Eigen::Vector3f>& vectors_;
    std::vector<float> values_;
    std::unordered_map<std::uint64_t, std::uint32_t> crossing_of_edge_;
    std::vector<Crossing> crossings_;
};

}  // namespace benchmarks
