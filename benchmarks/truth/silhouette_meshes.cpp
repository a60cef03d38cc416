// SPDX-License-Identifier: GPL-3.0-or-later
#include "silhouette_meshes.h"

#include <Eigen/Geometry>
#include <random>

#include "mesh_file.h"
#include "primitive_meshes.h"
#include "registry.h"

namespace benchmarks {
namespace {

using namespace test_meshes;

TriangleMesh mapped(TriangleMesh mesh,
                    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map) {
    for (Eigen::Vector3d& p : mesh.positions)
        p = map(p);
    return mesh;
}

TriangleMesh scaled(const TriangleMesh& mesh, double factor) {
    return mapped(mesh, [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(factor * p); });
}

TriangleMesh moved(const TriangleMesh& mesh, double distance) {
    return mapped(mesh, [&](const Eigen::Vector3d& p) {
        return Eigen::Vector3d(p + distance * Eigen::Vector3d(1, -0.7, 0.4));
    });
}

/// Triangles with corners of their own, every other one the wrong way around.
TriangleMesh soup_of(const TriangleMesh& mesh) {
    TriangleMesh soup = cut_apart(mesh);
    std::mt19937 random(7);
    for (Triangle& triangle : soup.triangles)
        if (random() % 2) std::swap(triangle[1], triangle[2]);
    return soup;
}

TriangleMesh with_both_sides(TriangleMesh mesh) {
    const std::size_t count = mesh.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle t = mesh.triangles[i];
        mesh.triangles.push_back({t[0], t[2], t[1]});
    }
    return mesh;
}

/// A box whose sides are divided each in its own way, so that corners of one lie on edges of
/// others.
TriangleMesh box_with_t_junctions() {
    TriangleMesh mesh;
    for (int side = 0; side < 6; ++side) {
        const double sign = side % 2 ? 1 : -1;
        append(mesh, mapped(plane(2 + side), [&](const Eigen::Vector3d& p) {
                   Eigen::Vector3d q;
                   q[side / 2] = sign;
                   q[(side / 2 + 1) % 3] = sign * p.x();
                   q[(side / 2 + 2) % 3] = p.y();
                   return Eigen::Vector3d(q.x(), 0.7 * q.y(), 0.5 * q.z());
               }));
    }
    return mesh;
}

/// A mesh and its mirror image on its right, which may touch.
TriangleMesh mirrored(const TriangleMesh& mesh) {
    double right = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& p : mesh.positions)
        right = std::max(right, p.x());
    TriangleMesh both = mesh, image = mapped(mesh, [&](const Eigen::Vector3d&p) {
                                  return Eigen::Vector3d(2 * right - p.x(), p.y(), p.z());
                              });
    flip_triangles(image, 1);
    append(both, image);
    return both;
}

TriangleMesh tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0.2, 0.9, 0}, {0.4, 0.3, 0.8}},
            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// Thousands of triangles on one edge or vertex take a minute each: smaller ones do. Bits of less
/// than a millimetre have no line that is long enough to be drawn.
bool is_left_out(const std::string& name) {
    for (const char* other : {"star", "cut_star", "book", "one_face_often", "scattered_tetrahedra",
                              "areas_below_floats"})
        if (name == other) return true;
    return false;
}

void add_own(std::vector<SilhouetteMesh>& meshes) {
    const auto add = [&](const char* name, std::function<TriangleMesh()> make) {
        meshes.push_back({name, std::move(make)});
    };
    const auto ring = [] { return torus(48, 24).mesh; };
    add("soup_of_torus", [=] { return soup_of(ring()); });
    add("soup_of_rounded_cube", [] { return soup_of(rounded_cube(16, 0.2)); });
    add("torus_with_both_sides", [=] { return with_both_sides(ring()); });
    add("box_with_t_junctions", box_with_t_junctions);
    add("tetrahedron", tetrahedron);
    add("star_of_100", [] { return star(100, false); });
    add("cut_star_of_100", [] { return star(100, true); });
    add("book_of_20", [] { return book(20); });
    add("one_face_20_times", [] { return one_face_often(20); });
    add("low_poly_sphere", [] { return icosphere(1); });
    add("low_poly_torus", [] { return torus(8, 5).mesh; });
    add("torus_1e-6", [=] { return scaled(ring(), 1e-6); });
    add("torus_1e6", [=] { return scaled(ring(), 1e6); });
    add("cube_1e-6", [] { return scaled(cube(4), 1e-6); });
    add("cube_1e6", [] { return scaled(cube(4), 1e6); });
    add("torus_far", [=] { return moved(ring(), 1e5); });
    add("cube_far", [] { return moved(cube(4), 1e5); });
    add("bumpy_sphere_mirrored", [] { return mirrored(bumpy_sphere(4, 0.15).mesh); });
}

}  // namespace

std::vector<SilhouetteMesh> silhouette_meshes() {
    std::vector<SilhouetteMesh> meshes;
    for (const MeshEntry& entry : all_entries())
        meshes.push_back({entry.name, [&] { return entry.get().mesh; }});
    bool has_not_finite = false;
    for (const MeshEntry& entry : wild_entries()) {
        const bool is_not_finite = entry.name.find("not_finite") != std::string::npos;
        if (entry.has(kUnusable) || is_left_out(entry.name) || (is_not_finite && has_not_finite))
            continue;
        has_not_finite |= is_not_finite;
        meshes.push_back({entry.name, [&] { return entry.get().mesh; }});
    }
    for (const Primitive& primitive : primitive_meshes())
        meshes.push_back({primitive.name, primitive.make});
    add_own(meshes);
    return meshes;
}

std::vector<SilhouetteMesh> scans_of(const std::string& file) {
    const auto read = [file] { return read_mesh(file); };
    return {{mesh_name(file), read},
            {mesh_name(file) + "_mirrored", [=] { return mirrored(read()); }}};
}

}  // namespace benchmarks
