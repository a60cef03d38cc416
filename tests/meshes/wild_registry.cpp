// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that nobody wants, and programs get all the same.
#include <cmath>
#include <limits>
#include <random>

#include "registry.h"
#include "wild_mesh.h"

namespace test_meshes {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TriangleMesh small_torus() {
    return torus(24, 12, 0.2).mesh;
}

TriangleMesh squeezed(double x, double y) {
    TriangleMesh mesh = small_torus();
    for (Eigen::Vector3d& p : mesh.positions)
        p = {x * p.x(), y * p.y(), p.z()};
    return mesh;
}

/// Vertices on a line, at two points or at one.
TriangleMesh without_area(int places) {
    TriangleMesh mesh;
    for (int i = 0; i < 300; ++i)
        mesh.positions.push_back(Eigen::Vector3d(1, 2, 3) * (i % places) / 7);
    for (std::uint32_t i = 0; i + 2 < 300; ++i)
        mesh.triangles.push_back({i, i + 1, i + 2});
    return mesh;
}

/// Beside the first torus, one that is a single point.
TriangleMesh collapsed_component() {
    TriangleMesh mesh = small_torus(), point = mesh;
    for (Eigen::Vector3d& p : point.positions)
        p = {3, 0, 0};
    append(mesh, point);
    return mesh;
}

TriangleMesh crossing_tori() {
    TriangleMesh mesh = small_torus(), other = mesh;
    for (Eigen::Vector3d& p : other.positions)
        p = {p.z() + 0.3, p.x(), p.y()};
    append(mesh, other);
    return mesh;
}

/// Sharing one vertex, with an unused one.
TriangleMesh kissing_spheres() {
    TriangleMesh mesh = icosphere(2), other = mesh;
    const Eigen::Vector3d top = mesh.positions[0];
    const auto first = std::uint32_t(mesh.positions.size());
    for (Eigen::Vector3d& p : other.positions)
        p = 2 * top - p;
    append(mesh, other);
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            if (v == first) v = 0;
    return mesh;
}

TriangleMesh reversed_sphere() {
    TriangleMesh mesh = icosphere(3);
    flip_triangles(mesh, 1);
    return mesh;
}

TriangleMesh nested_spheres() {
    TriangleMesh mesh = icosphere(3), inner = reversed_sphere();
    for (Eigen::Vector3d& p : inner.positions)
        p *= 0.99;
    append(mesh, inner);
    return mesh;
}

TriangleMesh scattered_tetrahedra(int count) {
    TriangleMesh mesh;
    std::mt19937 random(3);
    const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
    for (int i = 0; i < count; ++i) {
        const double x = unit(), y = unit(), z = unit();
        const Eigen::Vector3d p = 50 * Eigen::Vector3d(x, y, z);
        append(mesh, {{p, p + Eigen::Vector3d(0.3, 0, 0), p + Eigen::Vector3d(0, 0.3, 0),
                       p + Eigen::Vector3d(0, 0, 0.3)},
                      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
    }
    return mesh;
}

/// Areas that are 0 as floats, but not as doubles.
TriangleMesh tiny_sheets_far_apart() {
    TriangleMesh mesh;
    for (const double z : {0., 1.}) {
        TriangleMesh sheet = plane(4);
        for (Eigen::Vector3d& p : sheet.positions)
            p = {1e-24 * p.x(), 1e-24 * p.y(), z};
        append(mesh, sheet);
    }
    return mesh;
}

void add_shapes(std::vector<MeshEntry>& entries) {
    const auto add = [&](const char* name, unsigned tags, const auto& make) {
        entries.emplace_back(name, tags, [make] { return AnalyticMesh{TriangleMesh(make()), {}}; });
    };
    add("needles", 0, [] { return squeezed(1e-9, 1); });
    add("slivers", 0, [] { return squeezed(1e-6, 1e-6); });
    add("flat", 0, [] { return squeezed(0, 1); });
    add("collapsed_component", kDirty, [] { return collapsed_component(); });
    add("crossing_tori", kComponents, [] { return crossing_tori(); });
    add("kissing_spheres", kNonManifold | kDirty, [] { return kissing_spheres(); });
    add("reversed_sphere", kClosed, [] { return reversed_sphere(); });
    add("nested_spheres", kComponents, [] { return nested_spheres(); });
    add("scattered_tetrahedra", kComponents, [] { return scattered_tetrahedra(3000); });
    add("cut_apart", kComponents, [] { return cut_apart(small_torus()); });
    add("star", 0, [] { return star(3000, false); });
    add("cut_star", kComponents, [] { return star(3000, true); });
    add("book", kNonManifold, [] { return book(3000); });
    add("one_face_often", kNonManifold, [] { return one_face_often(3000); });
    add("areas_below_floats", kComponents, [] { return tiny_sheets_far_apart(); });
    add("far_away", 0, [] { return moved(small_torus(), {1e6, -1e6, 1e6}, 1); });
    add("huge", 0, [] { return moved(small_torus(), Eigen::Vector3d::Zero(), 1e8); });
    add("tiny", 0, [] { return moved(small_torus(), Eigen::Vector3d::Zero(), 1e-8); });
    add("tiny_and_far", 0, [] { return moved(small_torus(), {1e6, 0, 0}, 1e-3); });
    add("empty", kUnusable, [] { return TriangleMesh{}; });
    add("point_cloud", kUnusable, [] { return TriangleMesh{small_torus().positions, {}}; });
    add("on_a_line", kUnusable, [] { return without_area(300); });
    add("at_two_points", kUnusable, [] { return without_area(2); });
    add("at_one_point", kUnusable, [] { return without_area(1); });
    add("index_out_of_range", kUnusable, [] {
        return TriangleMesh{small_torus().positions, {{0, 1, 2}, {3, 4, 1u << 31}}};
    });
    add("beyond_all_sizes", kUnusable,
        [] { return moved(small_torus(), Eigen::Vector3d::Zero(), 1e200); });
    add("below_all_sizes", kUnusable,
        [] { return moved(small_torus(), Eigen::Vector3d::Zero(), 1e-200); });
}

/// The first, a middle, the last coordinate not finite; all; none left.
void add_not_finite(std::vector<MeshEntry>& entries) {
    for (int half : {0, 1, 2})
        for (int axis = 0; axis < 3; ++axis)
            for (double value : {kNaN, kInfinity, -kInfinity})
                entries.emplace_back("not_finite_" + std::to_string(entries.size()), kDirty, [=] {
                    AnalyticMesh mesh{small_torus(), {}};
                    const std::size_t last = mesh.mesh.positions.size() - 1;
                    mesh.mesh.positions[std::size_t(half) * last / 2][axis] = value;
                    return mesh;
                });
    entries.emplace_back("all_not_finite", kUnusable, [] {
        AnalyticMesh none{small_torus(), {}};
        for (std::size_t v = 0; v < none.mesh.positions.size(); ++v)
            none.mesh.positions[v][int(v % 3)] = v % 2 ? kNaN : kInfinity;
        return none;
    });
}

}  // namespace

TriangleMesh star(int triangles, bool cut) {
    TriangleMesh mesh;
    const auto count = std::uint32_t(triangles);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * i / count;
        mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.1 * std::sin(5 * angle)});
    }
    for (std::uint32_t i = 0; i < (cut ? count : 1); ++i)
        mesh.positions.push_back({0, 0, 0.5});
    for (std::uint32_t i = 0; i < count; ++i)
        mesh.triangles.push_back({count + (cut ? i : 0), i, (i + 1) % count});
    return mesh;
}

TriangleMesh book(int pages) {
    TriangleMesh mesh{{{0, 0, -1}, {0, 0, 1}}, {}};
    for (int i = 0; i < pages; ++i) {
        const double angle = 3.0 * i / pages;
        mesh.positions.push_back({std::cos(angle), std::sin(angle), 0});
        mesh.triangles.push_back({0, 1, std::uint32_t(i + 2)});
    }
    return mesh;
}

TriangleMesh one_face_often(int times) {
    TriangleMesh mesh = small_torus();
    const Triangle t = mesh.triangles[100];
    for (int i = 0; i < times; ++i)
        mesh.triangles.push_back(i % 2 ? t : Triangle{t[1], t[0], t[2]});
    return mesh;
}

const std::vector<MeshEntry>& wild_entries() {
    static const std::vector<MeshEntry> entries = [] {
        std::vector<MeshEntry> list;
        add_shapes(list);
        add_not_finite(list);
        return list;
    }();
    return entries;
}

}  // namespace test_meshes
