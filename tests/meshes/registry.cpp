// SPDX-License-Identifier: GPL-3.0-or-later
#include "registry.h"

#include <functional>
#include <map>
#include <mutex>
#include <random>
#include <stdexcept>

namespace test_meshes {
namespace {

struct Entry {
    const char* name;
    bool is_closed;
    std::function<AnalyticMesh()> make;
};

std::function<AnalyticMesh()> plain(std::function<TriangleMesh()> make) {
    return [make = std::move(make)] { return AnalyticMesh{make(), {}}; };
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

const std::vector<Entry>& entries() {
    const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0.1}}, {{0, 1, 2}}};
    static const std::vector<Entry> all = {
        {"sphere", true, [] { return sphere(4); }},
        {"torus", true, [] { return torus(80, 40); }},
        {"torus_jittered", true, [] { return torus(80, 40, 0.25); }},
        {"ellipsoid", true, [] { return ellipsoid(4); }},
        {"bumpy_sphere", true, [] { return bumpy_sphere(4, 0.15); }},
        {"hills", false, [] { return hills(48, 0.2); }},
        {"half_torus", false, [] { return half_torus(40, 40); }},
        {"cylinder", false, [] { return cylinder(48, 24); }},
        {"plane", false, plain([] { return plane(24, 0.2); })},
        {"cube", true, plain([] { return cube(10); })},
        {"rounded_cube", true, plain([] { return rounded_cube(40, 0.1); })},
        {"three_sheets", false, plain([] { return fan_of_sheets(3, 16); })},
        {"doubled_triangles", false, plain(doubled_sphere)},
        {"moebius_strip", false, plain([] { return moebius_strip(72, 12); })},
        {"flipped_torus", false, plain([] { return flipped(torus(40, 20, 0.2).mesh, 7); })},
        {"dirty_torus", false, plain(dirty_torus)},
        {"triangle_soup", false, plain(triangle_soup)},
        {"single_triangle", false, plain([triangle] { return triangle; })},
    };
    return all;
}

}  // namespace

std::vector<std::string> mesh_names() {
    std::vector<std::string> names;
    for (const Entry& entry : entries())
        names.push_back(entry.name);
    return names;
}

const TestMesh& mesh_named(const std::string& name) {
    static std::mutex one_at_a_time;
    static std::map<std::string, TestMesh> made;
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    if (const auto found = made.find(name); found != made.end()) return found->second;
    for (const Entry& entry : entries()) {
        if (entry.name != name) continue;
        AnalyticMesh mesh = entry.make();
        return made[name] = {name, std::move(mesh.mesh), entry.is_closed, std::move(mesh.truth)};
    }
    throw std::out_of_range("no test mesh " + name);
}

}  // namespace test_meshes
