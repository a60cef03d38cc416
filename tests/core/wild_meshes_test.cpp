// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the mesh, options and eye: no crash, finite results, or an error that says what to do.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "places.h"
#include "wild_case.h"
#include "wild_mesh.h"

namespace {

using namespace laplacian_lines;
using test_meshes::MeshEntry;
using test_meshes::TestMesh;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<const MeshEntry*> every_mesh() {
    std::vector<const MeshEntry*> entries = test_meshes::meshes_with(0);
    for (const MeshEntry& entry : test_meshes::wild_entries())
        entries.push_back(&entry);
    return entries;
}

class WildMesh : public testing::TestWithParam<const MeshEntry*> {
protected:
    const TriangleMesh& mesh() const { return GetParam()->get().mesh; }
    bool unusable() const { return GetParam()->has(test_meshes::kUnusable); }
};

TEST_P(WildMesh, IsRefusedWithAReasonOrHasAFiniteField) {
    if (!unusable()) {
        EXPECT_EQ(wild::complaint(mesh(), helpers::complete_field(mesh())), "");
        return;
    }
    try {
        precompute(mesh());
        ADD_FAILURE() << "not refused";
    } catch (const Error& error) {
        EXPECT_TRUE(error.code() == ErrorCode::EmptyMesh || error.code() == ErrorCode::InvalidMesh);
        EXPECT_GT(std::string(error.what()).size(), 30u);
    }
}

TEST_P(WildMesh, WhatIsLeftOutIsCountedAndZero) {
    if (unusable()) return;
    const Field field = precompute(mesh());
    std::size_t not_finite = 0, zeros = 0;
    for (std::size_t v = 0; v < mesh().positions.size(); ++v) {
        not_finite += !mesh().positions[v].allFinite();
        const bool is_zero = field.kernel_sizes[v] == 0;
        zeros += is_zero;
        if (!is_zero) continue;
        EXPECT_TRUE(field.normals[v].isZero() && field.laplacian_normals[v].isZero());
        EXPECT_TRUE(helpers::matrix(field.shape_operators[v]).isZero());
    }
    EXPECT_EQ(field.report.non_finite_vertices, not_finite);
    EXPECT_EQ(field.report.non_finite_vertices + field.report.unreferenced_vertices, zeros);
    EXPECT_EQ(GetParam()->has(test_meshes::kDirty), zeros > 0);
}

std::vector<View> usual_and_odd_views(const TriangleMesh& mesh, const FieldScale& scale) {
    std::vector<View> views;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : mesh.positions)
        if (p.allFinite()) centre = p;
    views.push_back(View::perspective(centre));  // on a vertex
    for (double distance : {1e-12, 1e-3, 0.1, 0.5, 3.0, 1e3, 1e12})
        for (const Eigen::Vector3d& side :
             {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.3, -0.5, -0.2)})
            views.push_back(View::perspective(centre + distance * scale.diagonal * side));
    for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1.0, 1.0, 1e-300, 1e300})
            views.push_back(View::orthographic(side * Eigen::Vector3d::Unit(axis)));
    views.push_back({centre, -1});
    views.push_back({centre, 1e-280});
    views.push_back({{1, 2, 3}, 0, Eigen::Vector3d(0, 1, 1e-200)});
    return views;
}

TEST_P(WildMesh, LinesAreFiniteFromAnyEye) {
    if (unusable()) return;
    const Field field = helpers::complete_field(mesh());
    const LineExtractor extractor(mesh(), field);
    LineStyle everything = helpers::all_kinds();
    everything.detail = 100;
    for (const View& view : usual_and_odd_views(mesh(), field.scale))
        for (const LineStyle& style : {everything, helpers::all_crossings_of_all_kinds()})
            EXPECT_EQ(wild::complaint(helpers::extract(extractor, view, style)), "")
                << view.eye.transpose() << ", " << view.w;
    const View view = View::perspective({3 * field.scale.diagonal, 0, 0});
    const LineVisibility visibility(mesh());
    ExtractionScratch scratch;
    const LineSet on_surface = extract_on_surface(extractor, view, everything, scratch);
    for (const bool in_picture : {false, true}) {
        const LineParts parts =
            visibility.parts(view, {on_surface}, {everything.shows, 1.2, true, in_picture});
        EXPECT_EQ(wild::complaint(parts.seen), "");
        EXPECT_EQ(wild::complaint(parts.hidden), "");
    }
}

TEST_P(WildMesh, EyesThatAreNotFiniteAreRefused) {
    if (unusable()) return;
    const LineExtractor extractor(mesh(), precompute(mesh()));
    for (double bad : {kNaN, kInfinity, -kInfinity})
        for (int axis = 0; axis < 3; ++axis)
            for (double w : {0.0, 1.0}) {
                View view{{1, 2, 3}, w};
                view.eye[axis] = bad;
                EXPECT_THROW(helpers::extract(extractor, view, {}), Error);
            }
}

INSTANTIATE_TEST_SUITE_P(Registry, WildMesh, testing::ValuesIn(every_mesh()),
                         [](const auto& info) { return info.param->name; });

// ---- where the fuzzers start ----

TEST(ByteMesh, IsReadAsWritten) {
    const TriangleMesh mesh =
        test_meshes::torus(15, 17, 0.2).mesh;  // as many vertices as there can be
    const std::vector<std::uint8_t> bytes = test_meshes::wild_mesh_bytes(mesh);
    test_meshes::Choices choices(bytes);
    const TriangleMesh read = test_meshes::wild_mesh(choices);
    EXPECT_TRUE(choices.exhausted());
    ASSERT_EQ(read.positions.size(), mesh.positions.size());
    EXPECT_EQ(read.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(read.triangles, mesh.triangles);
    const double scale = measure_scale(read).diagonal / measure_scale(mesh).diagonal;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        EXPECT_LT(((read.positions[v] - read.positions[0]) -
                   scale * (mesh.positions[v] - mesh.positions[0]))
                      .norm(),
                  0.01);
}

TEST(ByteMesh, KeepsWhatFits) {
    for (const MeshEntry* entry : every_mesh()) {
        const TestMesh* mesh = &entry->get();
        const std::vector<std::uint8_t> bytes = test_meshes::byte_mesh(mesh->mesh);
        test_meshes::Choices choices(bytes);
        const TriangleMesh read = test_meshes::read_byte_mesh(choices);
        EXPECT_TRUE(choices.exhausted()) << *mesh;
        const std::size_t in_range =
            mesh->name == "index_out_of_range" ? 1 : mesh->mesh.triangles.size();
        EXPECT_GE(read.triangles.size(), std::min<std::size_t>(in_range, 80)) << *mesh;
    }
}

TEST(WildInput, OfEveryMesh) {
    unsigned number = 0;
    for (const MeshEntry* entry : every_mesh()) {
        const TestMesh* mesh = &entry->get();
        const auto plain = wild::precompute_seed(mesh->mesh);
        const auto other = wild::precompute_seed(mesh->mesh, number);
        const auto views = wild::extract_seed(mesh->mesh, number++);
        test_meshes::Choices first(plain), second(other), third(views);
        EXPECT_EQ(wild::precompute_case(first) + wild::precompute_case(second), "") << *mesh;
        EXPECT_EQ(wild::extract_case(third), "") << *mesh;
    }
}

// ---- random input; what the fuzzers of tests/fuzz found ----

std::string run_both(const std::vector<std::uint8_t>& bytes) {
    test_meshes::Choices first(bytes), second(bytes);
    return wild::precompute_case(first) + wild::extract_case(second);
}

TEST(WildInput, OfRandomBytes) {
    for (unsigned seed = 0; seed < 300; ++seed)
        ASSERT_EQ(run_both(test_meshes::random_bytes(seed, 16 << seed % 6)), "") << "seed " << seed;
}

TEST(WildInput, ThatOnceDidHarm) {
    std::size_t count = 0;
    for (const auto& file :
         std::filesystem::directory_iterator(places::repository() / "tests/fuzz/found")) {
        std::ifstream in(file.path(), std::ios::binary);
        const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
        EXPECT_EQ(run_both(bytes), "") << file.path();
        ++count;
    }
    EXPECT_GT(count, 0u);
}

}  // namespace
