// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the mesh, options and eye: no crash, finite results, or an error that says what to do.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"
#include "test_paths.h"
#include "wild_case.h"

namespace {

using namespace laplacian_lines;
using namespace test_meshes;

TriangleMesh small_torus() {
    return torus(24, 12, 0.2).mesh;
}

TriangleMesh squeezed(double x, double y) {
    return mapped(small_torus(), [=](Eigen::Vector3d& p) { p = {x * p.x(), y * p.y(), p.z()}; });
}

TriangleMesh with_coordinate(std::size_t vertex, int axis, double value) {
    TriangleMesh mesh = small_torus();
    mesh.positions[vertex][axis] = value;
    return mesh;
}

TriangleMesh one_face_often() {
    TriangleMesh mesh = small_torus();
    const Triangle t = mesh.triangles[100];
    for (int i = 0; i < 100; ++i)
        mesh.triangles.push_back(i % 2 ? t : Triangle{t[1], t[0], t[2]});
    return mesh;
}

/// Sharing one vertex, with an unused one.
TriangleMesh touching_spheres() {
    const TriangleMesh one = icosphere(2);
    const auto first = std::uint32_t(one.positions.size());
    TriangleMesh mesh = together(one, moved(one, 2 * one.positions[0], -1));
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            if (v == first) v = 0;
    return mesh;
}

TriangleMesh scattered_tetrahedra() {
    TriangleMesh mesh;
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) {
        const double x = signed_unit(random), y = signed_unit(random);
        const Eigen::Vector3d p = 25 * Eigen::Vector3d(x, y, signed_unit(random)), a(0.3, 0, 0),
                              b(0, 0.3, 0), c(0, 0, 0.3);
        append(mesh, {{p, p + a, p + b, p + c}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
    }
    return mesh;
}

TriangleMesh soup() {
    TriangleMesh mesh = mesh_named("triangle_soup").mesh;
    mesh.triangles.resize(60);  // rays meet most of them
    return mesh;
}

struct WildMesh {
    const char* name;
    std::function<TriangleMesh()> make;
    bool is_refused = false;
};

const std::vector<WildMesh>& wild_meshes() {
    const Eigen::Vector3d here(0, 0, 0);
    static const std::vector<WildMesh> all = {
        {"needles", [] { return squeezed(1e-9, 1); }},
        {"slivers", [] { return squeezed(1e-6, 1e-6); }},
        {"flat", [] { return squeezed(0, 1); }},
        {"collapsed component",
         [=] { return together(small_torus(), moved(small_torus(), here, 0)); }},
        {"crossing tori",
         [] {
             return together(small_torus(), moved(small_torus(), {0.3, 0, 0}));
         }},
        {"nested spheres", [=] { return together(icosphere(3), moved(icosphere(3), here, 0.99)); }},
        {"touching spheres", touching_spheres},
        {"scattered tetrahedra", scattered_tetrahedra},
        {"cut apart", [] { return cut_apart(small_torus()); }},
        {"soup", soup},
        {"star", [] { return star(300); }},
        {"book", [] { return book(60); }},
        {"one face often", one_face_often},
        {"areas below floats",
         [=] {
             return together(moved(plane(4), here, 1e-24), moved(plane(4), {0, 0, 1}, 1e-24));
         }},
        {"far away",
         [] {
             return moved(small_torus(), {1e6, -1e6, 1e6});
         }},
        {"huge", [=] { return moved(small_torus(), here, 1e8); }},
        {"tiny and far",
         [] {
             return moved(small_torus(), {1e6, 0, 0}, 1e-3);
         }},
        {"first coordinate no number", [] { return with_coordinate(0, 0, kNaN); }},
        {"a coordinate infinite", [] { return with_coordinate(50, 1, kInfinity); }},
        {"last coordinate infinite", [] { return with_coordinate(287, 2, -kInfinity); }},
        {"empty", [] { return TriangleMesh(); }, true},
        {"points",
         [] {
             return TriangleMesh{small_torus().positions, {}};
         },
         true},
        {"on a line", [=] { return moved(on_a_line(300, 300), here, 1. / 7); }, true},
        {"at two points", [] { return on_a_line(300, 2); }, true},
        {"at one point", [] { return on_a_line(300, 1); }, true},
        {"no such vertex",
         [] {
             return TriangleMesh{{{0, 0, 0}}, {{0, 0, 1u << 31}}};
         },
         true},
        {"beyond all sizes", [=] { return moved(small_torus(), here, 1e200); }, true},
        {"below all sizes", [=] { return moved(small_torus(), here, 1e-200); }, true},
        {"nothing finite", [=] { return moved(small_torus(), here, kNaN); }, true},
    };
    return all;
}

/// On a vertex, near and far, exactly along axes, and odd ones.
std::vector<View> usual_and_odd_views(const TriangleMesh& mesh, double diagonal) {
    Eigen::Vector3d vertex = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : mesh.positions)
        if (p.allFinite()) vertex = p;
    std::vector<View> views = {View::perspective(vertex),
                               {vertex, -1},
                               {vertex, 1e-280},
                               {{1, 2, 3}, 0, Eigen::Vector3d(0, 1, 1e-200)}};
    for (double distance : {1e-12, 0.1, 3.0, 1e12})
        views.push_back(
            View::perspective(vertex + distance * diagonal * Eigen::Vector3d(0.3, -0.5, -0.2)));
    for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1.0, 1e-300, 1e300})
            views.push_back(View::orthographic(side * Eigen::Vector3d::Unit(axis)));
    return views;
}

void expect_sound_field(const TriangleMesh& mesh) {
    const Field field = helpers::complete_field(mesh);
    ASSERT_EQ(wild::violation(mesh, field), "");
    std::size_t not_finite = 0, zeros = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        not_finite += !mesh.positions[v].allFinite();
        if (!field.normals[v].isZero()) continue;
        ++zeros;
        EXPECT_TRUE(field.laplacian_normals[v].isZero());
    }
    EXPECT_EQ(field.report.non_finite_vertices, not_finite);
    EXPECT_EQ(not_finite + field.report.unreferenced_vertices, zeros);
}

void expect_sound_lines(const TriangleMesh& mesh) {
    const Field field = helpers::complete_field(mesh);
    const LineExtractor extractor(mesh, field);
    LineStyle everything = helpers::all_kinds();
    everything.detail = 100;
    for (const View& view : usual_and_odd_views(mesh, field.scale.diagonal))
        for (const LineStyle& style : {everything, helpers::all_crossings_of_all_kinds()})
            EXPECT_EQ(wild::violation(helpers::extract(extractor, view, style)), "")
                << view.eye.transpose() << ", " << view.w;
    const View view = View::perspective({3 * field.scale.diagonal, 0, 0});
    EXPECT_EQ(wild::violation(mesh, extractor, view, everything), "");
}

TEST(WildMeshes, HaveFiniteFieldsAndLinesFromAnyEyeOrAreRefusedWithAReason) {
    for (const WildMesh& wild : wild_meshes()) {
        SCOPED_TRACE(wild.name);
        if (!wild.is_refused) {
            const TriangleMesh mesh = wild.make();
            expect_sound_field(mesh);
            expect_sound_lines(mesh);
            continue;
        }
        try {
            precompute(wild.make());
            ADD_FAILURE() << "not refused";
        } catch (const Error& error) {
            EXPECT_TRUE(error.code() == ErrorCode::EmptyMesh ||
                        error.code() == ErrorCode::InvalidMesh);
            EXPECT_GT(std::string(error.what()).size(), 30u);
        }
    }
    for (const char* name : {"three_sheets", "dirty_torus", "single_triangle"}) {
        SCOPED_TRACE(name);
        expect_sound_lines(mesh_named(name).mesh);
    }
}

TEST(WildMeshes, HaveFiniteFieldsWithAnyOptions) {
    for (const std::string& name : mesh_names())
        for (int i = 0; i < 12; ++i) {
            PrecomputeOptions options;
            options.laplace_operator = LaplaceOperator(i % 2);
            options.normal_smoothing = NormalSmoothing(i / 2 % 2);
            options.gradient_estimator = GradientEstimator(i / 3 % 2);
            options.skip_opposite_sheet = options.correct_borders = i / 6 % 2;
            options.accuracy = 0.01;
            if (i > 6) options.kernel_size = std::pow(10, 90 * (i - 9));  // none reached, or all
            const TriangleMesh& mesh = mesh_named(name).mesh;
            EXPECT_EQ(wild::violation(mesh, precompute(mesh, options)), "") << name << ' ' << i;
        }
}

// ---- bytes, as the fuzzer of tests/fuzz makes them, and what it found

TEST(WildInput, OfMeshesWithChangedBytes) {
    std::mt19937 random(1);
    std::vector<std::vector<std::uint8_t>> inputs;
    for (const TriangleMesh& mesh : {torus(12, 7, 0.2).mesh, cube(2), fan_of_sheets(3, 3),
                                     hills(6, 0.3).mesh, bumpy_sphere(1).mesh})
        inputs.push_back(wild::bytes_of(mesh));
    for (int round = 0; round < 300; ++round) {
        std::vector<std::uint8_t> bytes = inputs[random() % inputs.size()];
        for (unsigned changes = random() % 12; changes > 0; --changes)
            bytes[random() % bytes.size()] = std::uint8_t(random());
        for (int more = 0; more < 60; ++more)
            bytes.push_back(std::uint8_t(random()));
        ASSERT_EQ(wild::violation_of_bytes(bytes.data(), bytes.size()), "") << "round " << round;
    }
}

TEST(WildInput, ThatOnceDidHarm) {
    std::size_t count = 0;
    for (const auto& file :
         std::filesystem::directory_iterator(test_paths::repository() / "tests/fuzz/found")) {
        std::ifstream in(file.path(), std::ios::binary);
        const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
        EXPECT_EQ(wild::violation_of_bytes(bytes.data(), bytes.size()), "") << file.path();
        ++count;
    }
    EXPECT_GT(count, 0u);
}

}  // namespace
