// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces cut open by duplicated vertices have the field and lines of the whole ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "mesh/equal_positions.h"
#include "mesh/stitching.h"

namespace {

using namespace laplacian_lines;
using test_meshes::append;
using test_meshes::cut_apart;
using test_meshes::inside_out;
using test_meshes::mesh_named;

/// Along the plane x = `at`, with separate vertices on each side.
TriangleMesh with_seam(const TriangleMesh& mesh, double at) {
    TriangleMesh cut;
    std::map<std::pair<bool, std::uint32_t>, std::uint32_t> vertices;
    for (Triangle t : mesh.triangles) {
        const bool side =
            (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]).x() / 3 < at;
        for (std::uint32_t& v : t) {
            const auto [place, is_new] =
                vertices.try_emplace({side, v}, std::uint32_t(cut.positions.size()));
            if (is_new) cut.positions.push_back(mesh.positions[v]);
            v = place->second;
        }
        cut.triangles.push_back(t);
    }
    return cut;
}

TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
    append(a, b);
    return a;
}

std::size_t sets_in(const TriangleMesh& mesh) {
    const std::vector<std::uint32_t> representative = stitch_cuts(mesh.positions, mesh.triangles);
    if (representative.empty()) return mesh.positions.size();
    return std::set<std::uint32_t>(representative.begin(), representative.end()).size();
}

LineStyle borders_only() {
    LineStyle style;
    style.shows = LineKindSet();
    style.shows[LineKind::Border] = true;
    return style;
}

/// But for rounding in sums of another order.
void expect_same_field(const TriangleMesh& whole, const TriangleMesh& cut) {
    const Field expected = precompute(whole), field = precompute(cut);
    EXPECT_EQ(field.report.welded_vertices, cut.positions.size() - whole.positions.size());
    EXPECT_EQ(field.report.unreferenced_vertices, 0u);
    EXPECT_NEAR(field.scale.mean_edge / expected.scale.mean_edge, 1, 1e-12);
    std::map<std::array<double, 3>, std::size_t> vertex;
    for (std::size_t v = 0; v < whole.positions.size(); ++v)
        vertex[{whole.positions[v].x(), whole.positions[v].y(), whole.positions[v].z()}] = v;
    double error = 0, size = 0;
    for (std::size_t v = 0; v < cut.positions.size(); ++v) {
        const Eigen::Vector3d& p = cut.positions[v];
        const std::size_t w = vertex.at({p.x(), p.y(), p.z()});
        EXPECT_LT((field.normals[v] - expected.normals[w]).norm(), 1e-4f);
        error += (field.laplacian_normals[v] - expected.laplacian_normals[w]).squaredNorm();
        size += expected.laplacian_normals[w].squaredNorm();
    }
    EXPECT_LT(error, 1e-6 * size);
}

void expect_same_lines(const TriangleMesh& whole, const TriangleMesh& cut) {
    const LineExtractor expected(whole, precompute(whole)), extractor(cut, precompute(cut));
    for (const View& view : helpers::random_views(whole, 5)) {
        const LineSet a = helpers::extract(expected, view, LineStyle()),
                      b = helpers::extract(extractor, view, LineStyle());
        EXPECT_NEAR(double(a.lines.size()), double(b.lines.size()), 0.05 * double(a.lines.size()));
        EXPECT_NEAR(helpers::total_length(a) / helpers::total_length(b), 1, 0.02);
        const LineSet borders = helpers::extract(expected, view, borders_only());
        EXPECT_EQ(helpers::extract(extractor, view, borders_only()).lines.size(),
                  borders.lines.size());
    }
}

class CutMesh : public testing::TestWithParam<const char*> {
protected:
    const TriangleMesh& whole() const { return mesh_named(GetParam()).mesh; }
};
INSTANTIATE_TEST_SUITE_P(Meshes, CutMesh,
                         testing::Values("bumpy_sphere", "half_torus", "rounded_cube", "torus"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(CutMesh, SoupHasTheFieldOfTheWhole) {
    expect_same_field(whole(), cut_apart(whole()));
}

TEST_P(CutMesh, SeamLeavesTheFieldAsItIs) {
    const TriangleMesh cut = with_seam(whole(), 0.1);
    ASSERT_GT(cut.positions.size(), whole().positions.size());
    expect_same_field(whole(), cut);
}

TEST_P(CutMesh, HasTheLinesOfTheWhole) {
    expect_same_lines(whole(), cut_apart(whole()));
    expect_same_lines(whole(), with_seam(whole(), 0.1));
}

TEST_P(CutMesh, StaysCutIfAskedTo) {
    const TriangleMesh cut = with_seam(whole(), 0.1);
    PrecomputeOptions options;
    options.weld_duplicates = false;
    const Field field = precompute(cut, options);
    EXPECT_EQ(field.report.welded_vertices, 0u);
    const LineExtractor extractor(cut, field), of_whole(whole(), precompute(whole()));
    const View view = View::orthographic({1, 2, 3});
    EXPECT_GT(helpers::total_length(helpers::extract(extractor, view, borders_only())),
              helpers::total_length(helpers::extract(of_whole, view, borders_only())) + 0.5);
}

TEST(Stitching, LeavesSheetsThatLieUponEachOther) {
    const TriangleMesh& sphere = mesh_named("bumpy_sphere").mesh;
    EXPECT_EQ(sets_in(together(sphere, inside_out(sphere))), 2 * sphere.positions.size());
    const TriangleMesh& open = mesh_named("half_torus").mesh;
    EXPECT_EQ(sets_in(together(open, open)), 2 * open.positions.size());
}

TEST(Stitching, LeavesSolidsThatTouch) {
    const TriangleMesh& cube = mesh_named("rounded_cube").mesh;
    double low = 1e9, high = -1e9;
    for (const Eigen::Vector3d& p : cube.positions)
        low = std::min(low, p.x()), high = std::max(high, p.x());
    EXPECT_EQ(sets_in(together(cube, test_meshes::moved(cube, {high - low, 0, 0}))),
              2 * cube.positions.size());
}

TEST(Stitching, LeavesPlacesWhereMoreThanTwoMeet) {
    TriangleMesh book;  // three pages, each with vertices of its own at the spine
    for (double angle : {0., 2., 4.}) {
        const auto n = std::uint32_t(book.positions.size());
        book.positions.insert(book.positions.end(),
                              {{0, 0, 0}, {0, 0, 1}, {std::cos(angle), std::sin(angle), 0}});
        book.triangles.push_back({n, n + 1, n + 2});
    }
    EXPECT_EQ(sets_in(book), book.positions.size());
}

/// They share a hash without being equal: a plain look-up would take hours.
TEST(Stitching, PassesOverVerticesThatAreNotNumbers) {
    TriangleMesh mesh = mesh_named("half_torus").mesh;
    const std::size_t count = mesh.positions.size();
    mesh.positions.resize(count + 1000000, Eigen::Vector3d::Constant(std::nan("")));
    EXPECT_EQ(sets_in(mesh), mesh.positions.size());
    EXPECT_EQ(sets_in(cut_apart(mesh_named("half_torus").mesh)), count);
}

TEST(Stitching, MinusZeroIsZero) {
    TriangleMesh two;
    two.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-0., 0, 0}, {0, 1, -0.}, {-1, 0, 0}};
    two.triangles = {{0, 2, 1}, {3, 4, 5}};
    EXPECT_EQ(sets_in(two), 4u);
}

/// CAD faces meet where coordinates are 0 but for rounding.
TEST(EqualPositions, AreTheSameButForRoundingOfZero) {
    using Positions = std::vector<Eigen::Vector3d>;
    const auto firsts = [](const Positions& positions) { return first_equal_positions(positions); };
    using Firsts = std::vector<std::uint32_t>;
    EXPECT_EQ(firsts({{15, 0, 1}, {15, -8.9e-16, 1}, {15, 1e-10, 1}, {15, -0.0, 1}}),
              (Firsts{0, 0, 2, 0}));
    EXPECT_EQ(firsts({{1e-15, 0, 0}, {2e-15, 0, 0}, {-0.0, 0, 0}, {0, 0, 0}}),
              (Firsts{0, 1, 2, 2}));
    EXPECT_EQ(firsts({{NAN, 0, 0}, {NAN, 0, 0}, {0, 0, INFINITY}, {0, 0, 0}}),
              (Firsts{0, 1, 2, 3}));
}

}  // namespace
