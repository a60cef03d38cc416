// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_methods.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace benchmarks {
namespace {

constexpr double kCutoff = 6.1;  // in √h
using Cell = std::array<int, 3>;

Cell cell_of(const Eigen::Vector3d& p, double size) {
    return {int(std::floor(p.x() / size)), int(std::floor(p.y() / size)),
            int(std::floor(p.z() / size))};
}

std::vector<double> masses(const laplacian_lines::TriangleMesh& mesh) {
    std::vector<double> m(mesh.positions.size(), 0);
    for (const auto& t : mesh.triangles) {
        const Eigen::Vector3d& a = mesh.positions[t[0]];
        const double area = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).norm() / 2;
        for (auto v : t)
            m[v] += area / 3;
    }
    return m;
}

}  // namespace

std::vector<Eigen::Vector3d> plain_belkin(const laplacian_lines::TriangleMesh& mesh,
                                          const std::vector<Eigen::Vector3f>& normals,
                                          double kernel_size) {
    const double h = kernel_size * kernel_size, radius = kCutoff * kernel_size;
    const std::vector<double> m = masses(mesh);
    std::map<Cell, std::vector<std::size_t>> cells;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        cells[cell_of(mesh.positions[v], radius)].push_back(v);
    std::vector<Eigen::Vector3d> result(mesh.positions.size(), Eigen::Vector3d::Zero());
    for (std::size_t p = 0; p < result.size(); ++p) {
        const Cell centre = cell_of(mesh.positions[p], radius);
        for (int i = 0; i < 27; ++i) {
            const auto cell = cells.find(
                {centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1});
            if (cell == cells.end()) continue;
            for (std::size_t q : cell->second) {
                const double squared = (mesh.positions[q] - mesh.positions[p]).squaredNorm();
                if (squared > radius * radius) continue;
                result[p] +=
                    m[q] * std::exp(-squared / (4 * h)) * (normals[q] - normals[p]).cast<double>();
            }
        }
        result[p] /= 4 * std::acos(-1.0) * h * h;
    }
    return result;
}

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

std::uint32_t PlainLines::crossing_on(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [found, is_new] = crossing_of_edge_.try_emplace(std::uint64_t(low) << 32 | high,
                                                               std::uint32_t(crossings_.size()));
    if (is_new) crossings_.push_back({zero_between(low, high)});
    return found->second;
}

void PlainLines::join(std::uint32_t a, std::uint32_t b) {
    for (const auto& [here, there] : {std::pair(a, b), std::pair(b, a)}) {
        auto& neighbours = crossings_[here].neighbours;
        neighbours[neighbours[0] == kNone ? 0 : 1] = there;
    }
}

/// Of closed lines the first point comes again at the end.
void PlainLines::follow(std::uint32_t first, std::vector<Eigen::Vector3f>& points) {
    for (std::uint32_t before = kNone, here = first; here != kNone;) {
        Crossing& c = crossings_[here];
        points.push_back(c.point);
        if (c.visited) return;  // once round
        c.visited = true;
        const std::uint32_t next = c.neighbours[c.neighbours[0] == before ? 1 : 0];
        before = here;
        here = next;
    }
}

void PlainLines::trace(const laplacian_lines::View& view, std::vector<Eigen::Vector3f>& points,
                       std::vector<std::uint32_t>& starts) {
    points.clear();
    starts.clear();
    crossings_.clear();
    crossing_of_edge_.clear();
    evaluate(view);
    for (const laplacian_lines::Triangle& t : mesh_.triangles) {
        std::uint32_t ends[2];
        int found = 0;
        for (int k = 0; k < 3; ++k)
            if (const std::uint32_t a = t[k], b = t[(k + 1) % 3]; is_crossed(a, b))
                ends[found++] = crossing_on(a, b);
        if (found == 2) join(ends[0], ends[1]);
    }
    for (const bool loops : {false, true})  // open ones first
        for (std::uint32_t c = 0; c < crossings_.size(); ++c)
            if (!crossings_[c].visited && (loops || crossings_[c].neighbours[1] == kNone)) {
                starts.push_back(std::uint32_t(points.size()));
                follow(c, points);
            }
}

}  // namespace benchmarks
