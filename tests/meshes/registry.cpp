// SPDX-License-Identifier: GPL-3.0-or-later
#include "registry.h"

#include <random>
#include <stdexcept>

namespace test_meshes {
namespace {

TestMesh analytic(const char* name, unsigned tags, AnalyticMesh&& mesh) {
    return {name, tags | kAnalytic, std::move(mesh.mesh), std::move(mesh.truth)};
}

TestMesh plain(const char* name, unsigned tags, TriangleMesh&& mesh) {
    return {name, tags, std::move(mesh), {}};
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

/// Two triangles back to back: closed, without a volume.
TriangleMesh pillow() {
    return {{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0.1}}, {{0, 1, 2}, {0, 2, 1}}};
}

TriangleMesh single_triangle() {
    return {{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0.1}}, {{0, 1, 2}}};
}

std::vector<TestMesh> generate() {
    std::vector<TestMesh> meshes;
    meshes.push_back(analytic("sphere", kClosed, sphere(4)));
    meshes.push_back(analytic("sphere_jittered", kClosed | kJittered, sphere(4, 1, 0.2)));
    meshes.push_back(analytic("torus", kClosed | kSymmetric, torus(80, 40)));
    meshes.push_back(analytic("torus_jittered", kClosed | kJittered, torus(80, 40, 0.25)));
    meshes.push_back(analytic("ellipsoid", kClosed, ellipsoid(4)));
    meshes.push_back(analytic("bumpy_sphere", kClosed | kJittered, bumpy_sphere(4, 0.15)));
    meshes.push_back(analytic("hills", kBorder | kJittered, hills(48, 0.2)));
    meshes.push_back(analytic("half_torus", kBorder, half_torus(40, 40)));
    meshes.push_back(analytic("cylinder", kBorder, cylinder(48, 24)));
    meshes.push_back(plain("plane", kBorder | kJittered, plane(24, 0.2)));
    meshes.push_back(plain("cube", kClosed | kSymmetric | kSharp, cube(10)));
    meshes.push_back(plain("rounded_cube", kClosed | kSymmetric, rounded_cube(40, 0.1)));
    meshes.push_back(plain("parallel_sheets", kBorder | kComponents, parallel_sheets(24, 0.1)));
    meshes.push_back(plain("three_sheets", kNonManifold | kSharp, fan_of_sheets(3, 16)));
    meshes.push_back(plain("five_sheets", kNonManifold | kSharp, fan_of_sheets(5, 12)));
    meshes.push_back(plain("doubled_triangles", kNonManifold, doubled_sphere()));
    meshes.push_back(plain("moebius_strip", kInconsistent, moebius_strip(72, 12)));
    meshes.push_back(plain("flipped_torus", kInconsistent, flipped_torus()));
    meshes.push_back(plain("dirty_torus", kDirty, dirty_torus()));
    meshes.push_back(plain("triangle_soup", kNonManifold | kSharp, triangle_soup()));
    meshes.push_back(plain("pillow", kClosed | kSharp, pillow()));
    meshes.push_back(plain("single_triangle", kBorder, single_triangle()));
    meshes.push_back(plain("scattered_spheres", kClosed | kComponents, scattered_spheres()));
    return meshes;
}

}  // namespace

const std::vector<TestMesh>& all_meshes() {
    static const std::vector<TestMesh> meshes = generate();
    return meshes;
}

std::vector<const TestMesh*> meshes_with(unsigned wanted, unsigned unwanted) {
    std::vector<const TestMesh*> found;
    for (const TestMesh& mesh : all_meshes())
        if (mesh.has(wanted) && !(mesh.tags & unwanted)) found.push_back(&mesh);
    return found;
}

const TestMesh& mesh_named(const std::string& name) {
    for (const TestMesh& mesh : all_meshes())
        if (mesh.name == name) return mesh;
    throw std::out_of_range("no test mesh " + name);
}

}  // namespace test_meshes
