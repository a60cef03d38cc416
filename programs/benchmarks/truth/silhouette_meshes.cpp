// SPDX-License-Identifier: GPL-3.0-or-later
#include "silhouette_meshes.h"

#include <Eigen/Geometry>
#include <random>

#include "mesh_file.h"
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

const Eigen::Vector3d kNowhere = Eigen::Vector3d::Zero(), kFar = {1e5, -7e4, 4e4};

/// Triangles with corners of their own, every other one flipped.
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

/// A box whose sides are divided differently, so that corners of one lie on edges of others.
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

/// With its mirror image on its right, which may touch.
TriangleMesh mirrored(const TriangleMesh& mesh) {
    double right = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& p : mesh.positions)
        right = std::max(right, p.x());
    TriangleMesh both = mesh;
    append(both, inside_out(mapped(mesh, [&](const Eigen::Vector3d& p) {
               return Eigen::Vector3d(2 * right - p.x(), p.y(), p.z());
           })));
    return both;
}

TriangleMesh tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0.2, 0.9, 0}, {0.4, 0.3, 0.8}},
            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

TriangleMesh octahedron() {
    return {
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// Around the z axis, at the radii in turn.
std::vector<Eigen::Vector3d> ring(int count, const std::vector<double>& radii, double z) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::acos(-1.0) * i / count;
        const double radius = radii[std::size_t(i) % radii.size()];
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return points;
}

/// Triangles from each edge of a ring, given its first vertex, to a vertex.
void close(TriangleMesh& mesh, std::uint32_t first, std::uint32_t count, std::uint32_t to,
           bool downwards) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = first + i, b = first + (i + 1) % count;
        mesh.triangles.push_back(downwards ? Triangle{b, a, to} : Triangle{a, b, to});
    }
}

/// Between two equal rings, with middles in floor and lid.
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

/// A point above each three of an icosahedron's corners.
TriangleMesh spiky_star() {
    TriangleMesh mesh = icosphere(0);
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

/// 12 x `cells`² triangles, no top.
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

/// An L: edges inwards and outwards.
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

/// As CAD programs and lessons have them, of few triangles and of many.
void add_primitives(std::vector<SilhouetteMesh>& list) {
    const auto add = [&](const std::string& name, std::function<TriangleMesh()> make) {
        list.push_back({name, std::move(make)});
    };
    for (int cells = 1; cells <= 64; cells *= 2) {
        const std::string count = std::to_string(12 * cells * cells);
        add("cube_" + count, [=] { return cube(cells); });
    }
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
        add("plate_" + count, [=] {
            return mapped(cube(cells), [](const Eigen::Vector3d& p) {
                return Eigen::Vector3d(p.x(), 0.03 * p.y(), p.z());
            });
        });
        add("open_box_" + count, [=] { return open_box(cells); });
    }
    for (int level = 0; level <= 3; ++level)
        add("icosphere_" + std::to_string(20 << 2 * level), [=] { return icosphere(level); });
    for (const auto& [columns, rows] :
         {std::pair{10, 5}, {16, 8}, {32, 16}, {70, 36}, {100, 50}, {316, 158}, {1000, 500}})
        add("torus_" + std::to_string(2 * columns * rows),
            [columns = columns, rows = rows] { return torus(columns, rows).mesh; });
    add("sheet_2", [] { return plane(1); });
    add("open_cylinder_of_12", [] { return cylinder(12, 1).mesh; });
}

/// Thousands of triangles on one edge or vertex take a minute each; smaller ones do. Bits below a
/// millimetre have no line long enough to draw.
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
    add("torus_1e-6", [=] { return moved(ring(), kNowhere, 1e-6); });
    add("torus_1e6", [=] { return moved(ring(), kNowhere, 1e6); });
    add("cube_1e-6", [] { return moved(cube(4), kNowhere, 1e-6); });
    add("cube_1e6", [] { return moved(cube(4), kNowhere, 1e6); });
    add("torus_far", [=] { return moved(ring(), kFar); });
    add("cube_far", [] { return moved(cube(4), kFar); });
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
    add_primitives(meshes);
    add_own(meshes);
    return meshes;
}

std::vector<SilhouetteMesh> scans_of(const std::string& file) {
    const auto read = [file] { return read_mesh(file); };
    return {{mesh_name(file), read},
            {mesh_name(file) + "_mirrored", [=] { return mirrored(read()); }}};
}

}  // namespace benchmarks
