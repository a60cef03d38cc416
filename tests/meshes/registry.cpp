// SPDX-License-Identifier: GPL-3.0-or-later
#include "registry.h"

#include <mutex>
#include <random>
#include <stdexcept>

namespace test_meshes {
namespace {

std::function<AnalyticMesh()> plain(std::function<TriangleMesh()> make) {
    return [make = std::move(make)] { return AnalyticMesh{make(), {}}; };
}

TriangleMesh scattered_spheres() {
    TriangleMesh mesh;
    for (int i = 0; i < 27; ++i) {
        TriangleMesh ball = icosphere(1);
        const Eigen::Vector3d centre(i % 3, i / 3 % 3, i / 9);
        for (Eigen::Vector3d& p : ball.positions)
            p = 0.1 * (1 + i % 5) * p + 1.1 * centre;
        append(mesh, ball);
    }
    return mesh;
}

TriangleMesh flipped_torus() {
    TriangleMesh mesh = torus(40, 20, 0.2).mesh;
    flip_triangles(mesh, 7);
    return mesh;
}

TriangleMesh doubled_sphere() {
    TriangleMesh mesh = icosphere(3);
    const std::size_t count = mesh.triangles.size();
    for (std::size_t i = 0; i < count; i += 3)
        mesh.triangles.push_back(mesh.triangles[i]);
    return mesh;
}

TriangleMesh dirty_torus() {
    std::vector<std::uint32_t> clean_vertex;
    return with_dirt(torus(40, 20, 0.2).mesh, clean_vertex);
}

/// Any three of 40 vertices: edges with one to many triangles, crossing each other.
TriangleMesh triangle_soup() {
    TriangleMesh mesh;
    std::mt19937 random(5);
    const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
    for (int v = 0; v < 40; ++v) {
        const double x = unit(), y = unit(), z = unit();
        mesh.positions.push_back({x, y, z});
    }
    for (std::uint32_t i = 0; i < 400; ++i) {
        const std::uint32_t a = i % 40, b = random() % 40, c = random() % 40;
        if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
    }
    return mesh;
}

/// Closed, without a volume.
TriangleMesh pillow() {
    return {{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0.1}}, {{0, 1, 2}, {0, 2, 1}}};
}

TriangleMesh single_triangle() {
    return {{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0.1}}, {{0, 1, 2}}};
}

}  // namespace

const TestMesh& MeshEntry::get() const {
    static std::mutex one_at_a_time;
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    if (!mesh_) {
        AnalyticMesh made = make_();
        mesh_ = std::make_shared<const TestMesh>(
            TestMesh{name, tags, std::move(made.mesh), std::move(made.truth)});
    }
    return *mesh_;
}

const std::vector<MeshEntry>& all_entries() {
    static const std::vector<MeshEntry> entries = {
        {"sphere", kClosed | kAnalytic, [] { return sphere(4); }},
        {"sphere_jittered", kClosed | kJittered | kAnalytic, [] { return sphere(4, 1, 0.2); }},
        {"torus", kClosed | kSymmetric | kAnalytic, [] { return torus(80, 40); }},
        {"torus_jittered", kClosed | kJittered | kAnalytic, [] { return torus(80, 40, 0.25); }},
        {"ellipsoid", kClosed | kAnalytic, [] { return ellipsoid(4); }},
        {"bumpy_sphere", kClosed | kJittered | kAnalytic, [] { return bumpy_sphere(4, 0.15); }},
        {"hills", kBorder | kJittered | kAnalytic, [] { return hills(48, 0.2); }},
        {"half_torus", kBorder | kAnalytic, [] { return half_torus(40, 40); }},
        {"cylinder", kBorder | kAnalytic, [] { return cylinder(48, 24); }},
        {"plane", kBorder | kJittered, plain([] { return plane(24, 0.2); })},
        {"cube", kClosed | kSymmetric | kSharp, plain([] { return cube(10); })},
        {"rounded_cube", kClosed | kSymmetric, plain([] { return rounded_cube(40, 0.1); })},
        {"parallel_sheets", kBorder | kComponents, plain([] { return parallel_sheets(24, 0.1); })},
        {"three_sheets", kNonManifold | kSharp, plain([] { return fan_of_sheets(3, 16); })},
        {"five_sheets", kNonManifold | kSharp, plain([] { return fan_of_sheets(5, 12); })},
        {"doubled_triangles", kNonManifold, plain(doubled_sphere)},
        {"moebius_strip", kInconsistent, plain([] { return moebius_strip(72, 12); })},
        {"flipped_torus", kInconsistent, plain(flipped_torus)},
        {"dirty_torus", kDirty, plain(dirty_torus)},
        {"triangle_soup", kNonManifold | kSharp, plain(triangle_soup)},
        {"pillow", kClosed | kSharp, plain(pillow)},
        {"single_triangle", kBorder, plain(single_triangle)},
        {"scattered_spheres", kClosed | kComponents, plain(scattered_spheres)},
    };
    return entries;
}

std::vector<const MeshEntry*> meshes_with(unsigned wanted, unsigned unwanted) {
    std::vector<const MeshEntry*> found;
    for (const MeshEntry& entry : all_entries())
        if (entry.has(wanted) && !(entry.tags & unwanted)) found.push_back(&entry);
    return found;
}

const TestMesh& mesh_named(const std::string& name) {
    for (const MeshEntry& entry : all_entries())
        if (entry.name == name) return entry.get();
    throw std::out_of_range("no test mesh " + name);
}

}  // namespace test_meshes
