// SPDX-License-Identifier: GPL-3.0-or-later
#include "naive_belkin.h"

#include <Eigen/Geometry>
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

std::vector<Eigen::Vector3d> naive_belkin(const laplacian_lines::TriangleMesh& mesh,
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

}  // namespace benchmarks
