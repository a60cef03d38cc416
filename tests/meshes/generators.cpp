// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "laplacian_lines/precompute.h"

namespace test_meshes {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Row by row.
std::vector<Eigen::Vector2d> grid_parameters(const Grid& grid) {
    std::mt19937 random(1);
    const int columns = grid.columns + !grid.wrap_u, rows = grid.rows + !grid.wrap_v;
    std::vector<Eigen::Vector2d> parameters;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            Eigen::Vector2d move(signed_unit(random), signed_unit(random));
            if (!grid.wrap_u && (i == 0 || i == columns - 1)) move.x() = 0;
            if (!grid.wrap_v && (j == 0 || j == rows - 1)) move.y() = 0;
            move *= grid.jitter;
            parameters.emplace_back((i + move.x()) / grid.columns, (j + move.y()) / grid.rows);
        }
    return parameters;
}

std::vector<Triangle> grid_triangles(const Grid& grid) {
    const int columns = grid.columns + !grid.wrap_u, rows = grid.rows + !grid.wrap_v;
    std::vector<Triangle> triangles;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const auto vertex = [&](int a, int b) {
                return std::uint32_t((j + b) % rows * columns + (i + a) % columns);
            };
            const std::uint32_t a = vertex(0, 0), b = vertex(1, 0), c = vertex(1, 1),
                                d = vertex(0, 1);
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    return triangles;
}

TriangleMesh icosahedron() {
    const double g = (1 + std::sqrt(5.0)) / 2;
    TriangleMesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (auto& p : mesh.positions)
        p.normalize();
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return mesh;
}

/// An icosphere, jittered by up to `jitter` edges, then mapped.
AnalyticMesh mapped_icosphere(int level, const DirectionMap& map, double jitter) {
    AnalyticMesh result{icosphere(level), {}};
    std::mt19937 random(7);
    const double edge = 1.1 / (1 << level);
    for (Eigen::Vector3d& p : result.mesh.positions) {
        const Eigen::Vector3d d = p;
        for (int k = 0; k < 3; ++k)
            p[k] = d[k] + jitter * edge * signed_unit(random);
        result.truth.push_back(surface_point(map, p.normalized()));
        p = result.truth.back().position;
    }
    return result;
}

}  // namespace

TriangleMesh grid_mesh(const Grid& grid,
                       const std::function<Eigen::Vector3d(double u, double v)>& point) {
    TriangleMesh mesh;
    for (const Eigen::Vector2d& p : grid_parameters(grid))
        mesh.positions.push_back(point(p.x(), p.y()));
    mesh.triangles = grid_triangles(grid);
    return mesh;
}

AnalyticMesh grid_mesh(const Grid& grid,
                       const std::function<SurfacePoint(double u, double v)>& point) {
    AnalyticMesh result;
    result.mesh = grid_mesh(grid, [&](double u, double v) -> Eigen::Vector3d {
        result.truth.push_back(point(u, v));
        return result.truth.back().position;
    });
    return result;
}

TriangleMesh subdivided(TriangleMesh mesh, int times) {
    for (int i = 0; i < times; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), 0);
            if (is_new) {
                found->second = std::uint32_t(mesh.positions.size());
                mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
            }
            return found->second;
        };
        std::vector<Triangle> split;
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
                split.push_back(t);
        }
        mesh.triangles.swap(split);
    }
    return mesh;
}

TriangleMesh icosphere(int level) {
    TriangleMesh mesh = icosahedron();
    for (int i = 0; i < level; ++i) {
        const std::size_t before = mesh.positions.size();
        mesh = subdivided(std::move(mesh));
        for (std::size_t v = before; v < mesh.positions.size(); ++v)
            mesh.positions[v].normalize();
    }
    return mesh;
}

TriangleMesh with_noise(TriangleMesh mesh, double share, unsigned seed) {
    const double length = share * laplacian_lines::measure_scale(mesh).mean_edge;
    std::mt19937 random(seed);
    for (Eigen::Vector3d& p : mesh.positions) {
        Eigen::Vector3d move;
        do {  // uniform: points of the cube outside the ball are drawn again
            for (double& x : move)
                x = signed_unit(random);
        } while (move.norm() > 1 || move.norm() <= 0.01);
        p += length * move.normalized();
    }
    return mesh;
}

AnalyticMesh sphere(int level, double radius, double jitter) {
    return mapped_icosphere(
        level, [=](const JetVector& d) { return sphere_map(d, radius); }, jitter);
}

AnalyticMesh ellipsoid(int level, double jitter) {
    return mapped_icosphere(
        level,
        [](const JetVector& d) {
            return ellipsoid_map(d, {1, 0.8, 0.6});
        },
        jitter);
}

AnalyticMesh bumpy_sphere(int level, double jitter) {
    return mapped_icosphere(level, bumpy_map, jitter);
}

AnalyticMesh torus(int columns, int rows, double jitter) {
    return grid_mesh({columns, rows, true, true, jitter},
                     [](double u, double v) { return torus_point({}, 2 * kPi * u, 2 * kPi * v); });
}

AnalyticMesh half_torus(int columns, int rows, double jitter) {
    return grid_mesh({columns, rows, false, true, jitter},
                     [](double u, double v) { return torus_point({}, kPi * u, 2 * kPi * v); });
}

AnalyticMesh hills(int cells, double jitter) {
    return grid_mesh({cells, cells, false, false, jitter},
                     [](double u, double v) { return hills_point(2 * u - 1, 2 * v - 1); });
}

AnalyticMesh cylinder(int columns, int rows) {
    return grid_mesh({columns, rows, true, false}, [](double u, double v) {
        const Eigen::Vector3d n(std::cos(2 * kPi * u), std::sin(2 * kPi * u), 0);
        const Eigen::Vector3d along(-n.y(), n.x(), 0);
        const Eigen::Matrix3d zero = Eigen::Matrix3d::Zero();
        return SurfacePoint{n + (2 * v - 1) * Eigen::Vector3d::UnitZ(),
                            n,
                            -n,
                            along * along.transpose(),
                            {zero, zero, zero}};
    });
}

TriangleMesh plane(int cells, double jitter) {
    return grid_mesh({cells, cells, false, false, jitter},
                     [](double u, double v) { return Eigen::Vector3d(2 * u - 1, 2 * v - 1, 0); });
}

}  // namespace test_meshes
