// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as files hold them: with invalid elements, with surfaces cut open by duplicated vertices.
// Field and lines are those of the repaired mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using test_meshes::append;
using test_meshes::cut_apart;
using test_meshes::flipped;
using test_meshes::mesh_named;
using test_meshes::together;

TEST(Cracks, DoNotRunOnFromOneToTheNext) {
    const double crack = 5e-5 * std::sqrt(8);  // of the diagonal of a plane
    TriangleMesh sheets;
    for (int i = 0; i < 60; ++i)
        append(sheets, test_meshes::moved(test_meshes::plane(2), {0, 0, 0.8 * crack * i}));
    const std::vector<Triangle> joined = conforming_triangles(sheets);
    ASSERT_EQ(joined.size(), sheets.triangles.size());
    int moved = 0;
    for (std::size_t t = 0; t < joined.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const double distance =
                (sheets.positions[joined[t][k]] - sheets.positions[sheets.triangles[t][k]]).norm();
            EXPECT_LE(distance, crack);
            moved += distance > 0;
        }
    EXPECT_GT(moved, 0);
}

struct DirtyTorus {
    TriangleMesh clean = test_meshes::torus(40, 20, 0.2).mesh;
    std::vector<std::uint32_t> clean_vertex;
    TriangleMesh dirty = test_meshes::with_dirt(clean, clean_vertex);
};

TEST(DirtyMesh, PartsLeftOutAreCounted) {
    const DirtyTorus torus;
    const MeshReport report = precompute(torus.dirty).report;
    EXPECT_EQ(report.vertices, torus.clean.positions.size() + 5);
    EXPECT_EQ(report.triangles, torus.clean.triangles.size() + 5);
    EXPECT_EQ(report.non_finite_vertices, 3u);
    EXPECT_EQ(report.unreferenced_vertices, 2u);
    EXPECT_EQ(report.degenerate_triangles, 5u);
}

TEST(DirtyMesh, TheRestIsAsWithoutTheDirt) {
    const DirtyTorus torus;
    const Field clean = precompute(torus.clean), dirty = precompute(torus.dirty);
    EXPECT_DOUBLE_EQ(clean.scale.diagonal, dirty.scale.diagonal);
    EXPECT_DOUBLE_EQ(clean.scale.mean_edge, dirty.scale.mean_edge);
    for (std::size_t v = 0; v < torus.clean.positions.size(); ++v) {
        const std::uint32_t d = torus.clean_vertex[v];
        const float size = clean.laplacian_normals[v].norm();
        EXPECT_LT((clean.laplacian_normals[v] - dirty.laplacian_normals[d]).norm(), 1e-5 * size);
        EXPECT_LT((clean.normals[v] - dirty.normals[d]).norm(), 1e-6);
        EXPECT_LT(
            (helpers::matrix(clean.shape_operators[v]) - helpers::matrix(dirty.shape_operators[d]))
                .norm(),
            1e-5);
    }
}

TEST(DirtyMesh, LinesAreAsWithoutTheDirt) {
    const DirtyTorus torus;
    const LineExtractor clean(torus.clean, precompute(torus.clean));
    const LineExtractor dirty(torus.dirty, precompute(torus.dirty));
    const View view = View::perspective({2, -3, 2});
    const LineSet a = helpers::extract(clean, view, helpers::all_crossings());
    const LineSet b = helpers::extract(dirty, view, helpers::all_crossings());
    ASSERT_FALSE(a.lines.empty());
    EXPECT_EQ(a.lines.size(), b.lines.size());
    EXPECT_EQ(a.points.size(), b.points.size());
    for (const LinePoint& p : a.points)
        EXPECT_LT(helpers::distance_to_lines(p.position.cast<double>(), b), 1e-4);
}

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

const LineStyle kBorders = helpers::only(LineKind::Border);

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
        const LineSet borders = helpers::extract(expected, view, kBorders);
        EXPECT_EQ(helpers::extract(extractor, view, kBorders).lines.size(), borders.lines.size());
    }
}

class CutMesh : public testing::TestWithParam<const char*> {
protected:
    const TriangleMesh& whole() const { return mesh_named(GetParam()).mesh; }
};
INSTANTIATE_TEST_SUITE_P(Meshes, CutMesh,
                         testing::Values("bumpy_sphere", "half_torus", "rounded_cube"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(CutMesh, HasTheFieldOfTheWhole) {
    expect_same_field(whole(), cut_apart(whole()));
    expect_same_field(whole(), with_seam(whole(), 0.1));
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
    EXPECT_GT(helpers::total_length(helpers::extract(extractor, view, kBorders)),
              helpers::total_length(helpers::extract(of_whole, view, kBorders)) + 0.5);
}

std::size_t welded(const TriangleMesh& mesh) {
    return precompute(mesh).report.welded_vertices;
}

TEST(Stitching, LeavesWhatMerelyTouches) {
    const TriangleMesh sphere = mesh_named("bumpy_sphere").mesh, cube = test_meshes::cube(4);
    EXPECT_EQ(welded(together(sphere, flipped(sphere))), 0u);
    EXPECT_EQ(welded(together(cube, test_meshes::moved(cube, {2, 0, 0}))), 0u);
    EXPECT_EQ(welded(cut_apart(test_meshes::book(3))), 0u);
}

/// They share a hash without being equal: a simple look-up would take hours.
TEST(Stitching, PassesOverVerticesThatAreNotNumbers) {
    TriangleMesh mesh = mesh_named("half_torus").mesh;
    mesh.positions.resize(mesh.positions.size() + 1000000, Eigen::Vector3d::Constant(std::nan("")));
    EXPECT_EQ(welded(mesh), 0u);
}

/// As programs write that have a mesh selected twice, or give faces two sides, with shared vertices
/// or as a soup; in open meshes also with vertices of their own.
TEST(Stitching, TakesDoubledMeshesOnce) {
    const TriangleMesh mesh = mesh_named("torus_jittered").mesh;
    const auto doubled = [](TriangleMesh one, const TriangleMesh& copy) {
        one.triangles.insert(one.triangles.end(), copy.triangles.begin(), copy.triangles.end());
        return one;
    };
    for (const TriangleMesh& copy : {mesh, flipped(mesh)}) {
        const TriangleMesh twice = doubled(mesh, copy);
        for (const TriangleMesh& written : {twice, cut_apart(twice)}) {
            EXPECT_EQ(conforming_triangles(written).size(), mesh.triangles.size());
            EXPECT_EQ(precompute(written).report.border_share, 0);
        }
    }
    const TriangleMesh soup = cut_apart(mesh);
    const Field expected = precompute(soup), field = precompute(doubled(soup, flipped(soup)));
    for (std::size_t v = 0; v < soup.positions.size(); ++v)
        EXPECT_LT((field.normals[v] - expected.normals[v]).norm(), 1e-5f) << v;
    const TriangleMesh open = mesh_named("half_torus").mesh;
    EXPECT_EQ(welded(together(open, open)), open.positions.size());
    for (const Eigen::Vector3f& n : precompute(together(open, open)).normals)
        EXPECT_NEAR(n.norm(), 1, 1e-5f);
}

/// Of a card, each of whose sides is cut along other diagonals, areas cancel but for rounding.
TEST(VertexNormals, AreThoseOfAFaceWhereFacesCancel) {
    TriangleMesh card = test_meshes::mapped(
        test_meshes::plane(8), [](Eigen::Vector3d& p) { p.z() = 0.3 * p.x() + 0.7 * p.y(); });
    for (Triangle t : std::vector<Triangle>(card.triangles)) {
        for (std::uint32_t& v : t)
            v = v / 9 * 9 + 8 - v % 9;  // mirrored
        card.triangles.push_back(t);
    }
    for (const Eigen::Vector3f& n : precompute(card).normals)
        EXPECT_NEAR(std::abs(n.dot(Eigen::Vector3f(-0.3f, -0.7f, 1).normalized())), 1, 1e-5f);
}

/// As files without data at some places have them.
TEST(Stitching, PassesOverVerticesFarOff) {
    const TriangleMesh &whole = mesh_named("half_torus").mesh, cut = cut_apart(whole);
    TriangleMesh mesh = cut;
    mesh.positions.push_back(Eigen::Vector3d::Constant(1e30));
    EXPECT_EQ(welded(mesh), cut.positions.size() - whole.positions.size());
    EXPECT_EQ(conforming_triangles(mesh), conforming_triangles(cut));
}

/// CAD programs leave 1e-15 where coordinates are 0. Closed bodies have no cracks to be closed:
/// only positions that count as equal tell that the second is a copy.
TEST(Stitching, TakesZeroAsItIsRounded) {
    const TriangleMesh cube = test_meshes::cube(2);
    for (const double zero : {-0., -8.9e-16, 8.9e-16}) {
        const TriangleMesh copy = test_meshes::mapped(cube, [=](Eigen::Vector3d& p) {
            for (double& x : p)
                if (x == 0) x = zero;
        });
        EXPECT_EQ(conforming_triangles(together(cube, copy)).size(), cube.triangles.size()) << zero;
    }
}

}  // namespace
