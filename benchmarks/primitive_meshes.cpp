// SPDX-License-Identifier: GPL-3.0-or-later
#include "primitive_meshes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "generators.h"

namespace benchmarks {
namespace {

using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;
using test_meshes::cube;

TriangleMesh tetrahedron() {
    return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
            {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

TriangleMesh octahedron() {
    return {
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// Points around the z axis at the radii, in turn.
std::vector<Eigen::Vector3d> ring(int count, const std::vector<double>& radii, double z) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::acos(-1.0) * i / count;
        const double radius = radii[std::size_t(i) % radii.size()];
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return points;
}

/// Triangles from each edge of a ring of `count` vertices, the first of which is named, to a
/// vertex.
void close(TriangleMesh& mesh, std::uint32_t first, std::uint32_t count, std::uint32_t to,
           bool downwards) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = first + i, b = first + (i + 1) % count;
        mesh.triangles.push_back(downwards ? Triangle{b, a, to} : Triangle{a, b, to});
    }
}

/// A solid between two equal rings, with a middle in its floor and in its lid.
TriangleMesh prism(int sides, const std::vector<double>& radii, double height) {
    TriangleMesh mesh;
    const auto n = std::uint32_t(sides);
    for (double z : {-height / 2, height / 2})
        for (const Eigen::Vector3d& p : ring(sides, radii, z))
            mesh.positions.push_back(p);
    mesh.positions.push_back({0, 0, -height / 2});
    mesh.positions.push_back({0, 0, height / 2});
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = i, b = (i + 1) % n;
        mesh.triangles.push_back({a, b, n + b});
        mesh.triangles.push_back({a, n + b, n + a});
    }
    close(mesh, 0, n, 2 * n, true);
    close(mesh, n, n, 2 * n + 1, false);
    return mesh;
}

TriangleMesh cone(int sides) {
    TriangleMesh mesh{ring(sides, {1}, -1), {}};
    mesh.positions.push_back({0, 0, -1});
    mesh.positions.push_back({0, 0, 1});
    const auto n = std::uint32_t(sides);
    close(mesh, 0, n, n, true);
    close(mesh, 0, n, n + 1, false);
    return mesh;
}

/// A point between and above each three of an icosahedron's corners.
TriangleMesh spiky_star() {
    TriangleMesh mesh = test_meshes::icosphere(0);
    std::vector<Triangle> faces;
    faces.swap(mesh.triangles);
    for (const Triangle& t : faces) {
        const Eigen::Vector3d middle =
            mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]];
        const auto top = std::uint32_t(mesh.positions.size());
        mesh.positions.push_back(2 * middle.normalized());
        for (std::size_t k = 0; k < 3; ++k)
            mesh.triangles.push_back({t[k], t[(k + 1) % 3], top});
    }
    return mesh;
}

TriangleMesh stretched(TriangleMesh mesh, const Eigen::Vector3d& factors) {
    for (Eigen::Vector3d& p : mesh.positions)
        p = p.cwiseProduct(factors);
    return mesh;
}

/// A cube of 12 x `cells`² triangles without its top.
TriangleMesh open_box(int cells) {
    TriangleMesh mesh = cube(cells);
    std::vector<Triangle> faces;
    faces.swap(mesh.triangles);
    for (const Triangle& t : faces) {
        const double low = std::min(
            {mesh.positions[t[0]].y(), mesh.positions[t[1]].y(), mesh.positions[t[2]].y()});
        if (low < 1) mesh.triangles.push_back(t);
    }
    return mesh;
}

/// An L: edges inwards as well as outwards.
TriangleMesh angle_iron() {
    TriangleMesh mesh;
    const double outline[][2] = {{-1, -1}, {1, -1}, {1, -0.5}, {-0.5, -0.5}, {-0.5, 1}, {-1, 1}};
    for (double z : {-0.8, 0.8})
        for (const auto& p : outline)
            mesh.positions.push_back({p[0], p[1], z});
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t next = (i + 1) % 6;
        mesh.triangles.push_back({i, next, 6 + next});
        mesh.triangles.push_back({i, 6 + next, 6 + i});
    }
    for (const Triangle& t : {Triangle{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
        mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
        mesh.triangles.push_back({t[2], t[1], t[0]});
    }
    return mesh;
}

void add_sharp(std::vector<Primitive>& list) {
    const auto add = [&](const std::string& name, std::function<TriangleMesh()> make) {
        list.push_back({name, true, std::move(make)});
    };
    for (int cells = 1; cells <= 64; cells *= 2) {
        const std::string count = std::to_string(12 * cells * cells);
        add("cube_" + count, [cells] { return cube(cells); });
    }
    add("tetrahedron", tetrahedron);
    add("octahedron", octahedron);
    add("spiky_star", spiky_star);
    add("star_prism", [] { return prism(10, {1, 0.45}, 0.6); });
    add("angle_iron", angle_iron);
    for (int sides : {6, 8, 12, 24, 48}) {
        add("cylinder_of_" + std::to_string(sides), [=] { return prism(sides, {0.5}, 2); });
        add("cone_of_" + std::to_string(sides), [=] { return cone(sides); });
    }
    for (int cells : {1, 8, 32}) {
        const std::string count = std::to_string(12 * cells * cells);
        add("plate_" + count, [=] { return stretched(cube(cells), {1, 0.03, 1}); });
        add("open_box_" + count, [=] { return open_box(cells); });
    }
}

void add_smooth(std::vector<Primitive>& list) {
    const auto add = [&](const std::string& name, std::function<TriangleMesh()> make) {
        list.push_back({name, false, std::move(make)});
    };
    for (int level = 0; level <= 3; ++level)
        add("icosphere_" + std::to_string(20 << 2 * level),
            [=] { return test_meshes::icosphere(level); });
    for (const auto& [columns, rows] :
         {std::pair{10, 5}, {16, 8}, {32, 16}, {70, 36}, {100, 50}, {316, 158}, {1000, 500}})
        add("torus_" + std::to_string(2 * columns * rows),
            [columns = columns, rows = rows] { return test_meshes::torus(columns, rows).mesh; });
    add("sheet_2", [] { return test_meshes::plane(1); });
    add("open_cylinder_of_12", [] { return test_meshes::cylinder(12, 1).mesh; });
}

}  // namespace

std::vector<Primitive> primitive_meshes() {
    std::vector<Primitive> list;
    add_sharp(list);
    add_smooth(list);
    return list;
}

}  // namespace benchmarks
