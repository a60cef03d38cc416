// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "laplacian_lines/precompute.h"

namespace test_meshes {
namespace {

/// Row by row.
std::vector<Eigen::Vector2d> grid_parameters(const Grid& grid) {
    std::mt19937 random(1);
    const int columns = grid.columns + !grid.wrap_u, rows = grid.rows + !grid.wrap_v;
    std::vector<Eigen::Vector2d> parameters;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            Eigen::Vector2d move;
            move.y() = signed_unit(random);
            move.x() = signed_unit(random);
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

/// An icosphere, jittered by up to `jitter` edges along each axis, then mapped.
AnalyticMesh mapped_icosphere(int level, double jitter,
                              const std::function<SurfacePoint(const Eigen::Vector3d&)>& point) {
    AnalyticMesh result{icosphere(level), {}};
    std::mt19937 random(7);
    const double edge = 1.1 / (1 << level);  // nearly: an icosahedron's is 1.05
    for (Eigen::Vector3d& p : result.mesh.positions) {
        const Eigen::Vector3d d = p;
        for (int k = 0; k < 3; ++k)
            p[k] = d[k] + jitter * edge * signed_unit(random);
        result.truth.push_back(point(p.normalized()));
        p = result.truth.back().position;
    }
    return result;
}

/// Merges vertices at exactly the same place and drops unused ones.
TriangleMesh welded(const TriangleMesh& mesh) {
    std::map<std::tuple<double, double, double>, std::uint32_t> place;
    TriangleMesh result;
    for (Triangle t : mesh.triangles) {
        for (std::uint32_t& v : t) {
            const Eigen::Vector3d& p = mesh.positions[v];
            const auto [found, is_new] = place.try_emplace(std::make_tuple(p.x(), p.y(), p.z()),
                                                           std::uint32_t(result.positions.size()));
            if (is_new) result.positions.push_back(p);
            v = found->second;
        }
        result.triangles.push_back(t);
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
    return mapped_icosphere(level, jitter, [=](const Eigen::Vector3d& d) {
        return ellipsoid_point(d, Eigen::Vector3d::Constant(radius));
    });
}

AnalyticMesh ellipsoid(int level, double jitter) {
    return mapped_icosphere(level, jitter, [](const Eigen::Vector3d& d) {
        return ellipsoid_point(d, {1, 0.8, 0.6});
    });
}

AnalyticMesh bumpy_sphere(int level, double jitter) {
    return mapped_icosphere(level, jitter, bumpy_point);
}

AnalyticMesh torus(int columns, int rows, double jitter) {
    return grid_mesh({columns, rows, true, true, jitter}, [](double u, double v) {
        return torus_point({}, 2 * M_PI * u, 2 * M_PI * v);
    });
}

AnalyticMesh half_torus(int columns, int rows, double jitter) {
    return grid_mesh({columns, rows, false, true, jitter},
                     [](double u, double v) { return torus_point({}, M_PI * u, 2 * M_PI * v); });
}

AnalyticMesh hills(int cells, double jitter) {
    return grid_mesh({cells, cells, false, false, jitter},
                     [](double u, double v) { return hills_point(2 * u - 1, 2 * v - 1); });
}

AnalyticMesh cylinder(int columns, int rows) {
    return grid_mesh({columns, rows, true, false}, [](double u, double v) {
        const Eigen::Vector3d n(std::cos(2 * M_PI * u), std::sin(2 * M_PI * u), 0);
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

// ---- meshes that are not smooth closed surfaces

TriangleMesh cube(int cells) {
    TriangleMesh faces;
    for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1.0, 1.0})
            append(faces, grid_mesh({cells, cells}, [&](double u, double v) {
                       Eigen::Vector3d p;
                       p[axis] = side;
                       p[(axis + (side > 0 ? 1 : 2)) % 3] = 2 * u - 1;
                       p[(axis + (side > 0 ? 2 : 1)) % 3] = 2 * v - 1;
                       return p;
                   }));
    return welded(faces);
}

TriangleMesh rounded_cube(int cells, double radius) {
    return mapped(cube(cells), [=](Eigen::Vector3d& p) {
        const Eigen::Vector3d inner = p.cwiseMax(radius - 1).cwiseMin(1 - radius);
        p = inner + radius * (p - inner).normalized();
    });
}

TriangleMesh stacked(const std::vector<Eigen::Vector3d>& rectangles, unsigned diagonals) {
    TriangleMesh mesh;
    for (const Eigen::Vector3d& r : rectangles)
        for (const auto& [x, y] : {std::pair(1, 1), {-1, 1}, {-1, -1}, {1, -1}})
            mesh.positions.push_back({x * r.x(), y * r.y(), r.z()});
    unsigned face = 0;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        const bool other = diagonals >> (face++ % 32) & 1;
        mesh.triangles.push_back({a, b, other ? d : c});
        mesh.triangles.push_back({other ? b : a, c, d});
    };
    const std::uint32_t top = std::uint32_t(mesh.positions.size()) - 4;
    add(3, 2, 1, 0);
    add(top, top + 1, top + 2, top + 3);
    for (std::uint32_t ring = 0; ring < top; ring += 4)
        for (std::uint32_t i = 0; i < 4; ++i)
            add(ring + i, ring + (i + 1) % 4, ring + 4 + (i + 1) % 4, ring + 4 + i);
    return mesh;
}

TriangleMesh prism(const std::vector<Eigen::Vector2d>& corners, double low, double high) {
    TriangleMesh mesh;
    const auto n = std::uint32_t(corners.size());
    for (const double z : {low, high})
        for (const Eigen::Vector2d& p : corners)
            mesh.positions.push_back({p.x(), p.y(), z});
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t next = (i + 1) % n;
        mesh.triangles.insert(mesh.triangles.end(), {{i, next, n + next}, {i, n + next, n + i}});
        if (i > 0 && next > 0)
            mesh.triangles.insert(mesh.triangles.end(), {{0, next, i}, {n, n + i, n + next}});
    }
    return mesh;
}

Ring circle(std::uint32_t sides, double radius, double z, double first_angle) {
    Ring ring;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = first_angle + 2 * M_PI * i / sides;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
    return ring;
}

TriangleMesh walls(const std::vector<Ring>& rings) {
    TriangleMesh mesh;
    for (const Ring& ring : rings)
        mesh.positions.insert(mesh.positions.end(), ring.begin(), ring.end());
    const auto sides = std::uint32_t(rings.front().size());
    for (std::uint32_t ring = 0; ring + sides < mesh.positions.size(); ring += sides)
        for (std::uint32_t i = 0; i < sides; ++i) {
            const std::uint32_t a = ring + i, b = ring + (i + 1) % sides;
            mesh.triangles.push_back({a, b, b + sides});
            mesh.triangles.push_back({a, b + sides, a + sides});
        }
    return mesh;
}

TriangleMesh moebius_strip(int columns, int rows) {
    TriangleMesh mesh = grid_mesh({columns, rows}, [](double u, double v) {
        const double turn = M_PI * u, across = 0.6 * (v - 0.5);
        const double ring = 1 + across * std::cos(turn);
        return Eigen::Vector3d(ring * std::cos(2 * turn), ring * std::sin(2 * turn),
                               across * std::sin(turn));
    });
    // The last column is the first one upside down.
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t) {
            const int column = int(v) % (columns + 1), row = int(v) / (columns + 1);
            if (column == columns) v = std::uint32_t((rows - row) * (columns + 1));
        }
    return welded(mesh);
}

TriangleMesh fan_of_sheets(int sheets, int cells) {
    TriangleMesh fan;
    for (int s = 0; s < sheets; ++s) {
        const double angle = 2 * M_PI * s / sheets + 0.2;
        append(fan, grid_mesh({cells, cells}, [&](double u, double v) {
                   const double bulge = 0.2 * std::sin(3 * u) * std::sin(4 * v);
                   return Eigen::Vector3d(u * std::cos(angle + bulge), u * std::sin(angle + bulge),
                                          2 * v - 1);
               }));
    }
    return welded(fan);
}

TriangleMesh parallel_sheets(int cells, double distance) {
    return together(flipped(plane(cells)), moved(plane(cells), {0, 0, distance}));
}

TriangleMesh star(int triangles) {
    TriangleMesh mesh;
    const auto count = std::uint32_t(triangles);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * i / count;
        mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.1 * std::sin(5 * angle)});
        mesh.triangles.push_back({count, i, (i + 1) % count});
    }
    mesh.positions.push_back({0, 0, 0.5});
    return mesh;
}

TriangleMesh book(int pages, double opening) {
    TriangleMesh mesh{{{0, 0, -1}, {0, 0, 1}}, {}};
    for (int i = 0; i < pages; ++i) {
        const double angle = opening * i / pages;
        mesh.positions.push_back({std::cos(angle), std::sin(angle), 0});
        mesh.triangles.push_back({0, 1, std::uint32_t(i + 2)});
    }
    return mesh;
}

TriangleMesh on_a_line(std::uint32_t vertices, std::uint32_t places) {
    TriangleMesh mesh;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        mesh.positions.push_back(Eigen::Vector3d(1, 2, 3) * (v % places));
        if (v > 1) mesh.triangles.push_back({v - 2, v - 1, v});
    }
    return mesh;
}

TriangleMesh cut_apart(const TriangleMesh& mesh) {
    TriangleMesh apart;
    for (const Triangle& t : mesh.triangles) {
        const auto first = std::uint32_t(apart.positions.size());
        for (std::uint32_t v : t)
            apart.positions.push_back(mesh.positions[v]);
        apart.triangles.push_back({first, first + 1, first + 2});
    }
    return apart;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
    const auto first = std::uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

TriangleMesh together(TriangleMesh mesh, const TriangleMesh& other) {
    append(mesh, other);
    return mesh;
}

TriangleMesh flipped(TriangleMesh mesh, int every) {
    for (std::size_t i = 0; i < mesh.triangles.size(); i += std::size_t(every))
        std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
    return mesh;
}

TriangleMesh cavity(TriangleMesh mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh.positions)
        box.extend(p);
    return together(flipped(std::move(mesh)), mapped(cube(1), [&](Eigen::Vector3d& p) {
                        p = box.center() + 0.51 * box.sizes().cwiseProduct(p);
                    }));
}

TriangleMesh moved(TriangleMesh mesh, const Eigen::Vector3d& by, double factor) {
    return mapped(std::move(mesh), [&](Eigen::Vector3d& p) { p = factor * p + by; });
}

TriangleMesh rounded_to_floats(TriangleMesh mesh) {
    std::vector<Eigen::Vector3f> floats;  // in memory: GCC 12 does not round two at once to and fro
    for (const Eigen::Vector3d& p : mesh.positions)
        floats.push_back(p.cast<float>());
    for (std::size_t v = 0; v < floats.size(); ++v)
        mesh.positions[v] = floats[v].cast<double>();
    return mesh;
}

TriangleMesh with_dirt(const TriangleMesh& mesh, std::vector<std::uint32_t>& clean_vertex) {
    TriangleMesh dirty;
    dirty.positions = {{kNaN, 0, 0}, {1e5, 2e5, -3e5}};  // the second one has no triangle
    clean_vertex.clear();
    const auto half = mesh.positions.size() / 2;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        if (v == half) dirty.positions.push_back({0, kInfinity, 0});
        clean_vertex.push_back(std::uint32_t(dirty.positions.size()));
        dirty.positions.push_back(mesh.positions[v]);
    }
    const auto last = std::uint32_t(dirty.positions.size());
    dirty.positions.push_back({0, 0, -kInfinity});
    dirty.positions.push_back(mesh.positions[0]);  // used by a triangle without area only
    const std::uint32_t a = clean_vertex[0], b = clean_vertex[1];
    dirty.triangles = {{0, a, b}, {a, a, b}, {a, b, last + 1}};
    for (const Triangle& t : mesh.triangles)
        dirty.triangles.push_back({clean_vertex[t[0]], clean_vertex[t[1]], clean_vertex[t[2]]});
    dirty.triangles.push_back({b, last, a});
    dirty.triangles.push_back({b, b, b});
    return dirty;
}

}  // namespace test_meshes
