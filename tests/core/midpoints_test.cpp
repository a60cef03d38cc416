// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes whose triangles were all cut in four at the middles of their sides: fields and lines are
// those of the mesh before.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "generators.h"
#include "helpers.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/tangent_frame.h"
#include "mesh/midpoints.h"
#include "mesh_noise.h"
#include "midpoint_subdivision.h"

namespace {

using namespace laplacian_lines;

TriangleMesh scan() {
    return mesh_noise::with_noise(test_meshes::bumpy_sphere(4).mesh, 0.1);
}

TriangleMesh subdivided(TriangleMesh mesh, int times) {
    test_meshes::subdivide(mesh, times);
    return mesh;
}

TriangleMesh rounded_to_floats(TriangleMesh mesh) {
    std::vector<Eigen::Vector3f> floats;  // in memory: GCC 12 does not round two at once to and fro
    for (const Eigen::Vector3d& p : mesh.positions)
        floats.push_back(p.cast<float>());
    for (std::size_t v = 0; v < floats.size(); ++v)
        mesh.positions[v] = floats[v].cast<double>();
    return mesh;
}

/// Vertices, triangles and their corners in another order.
TriangleMesh shuffled(const TriangleMesh& mesh) {
    std::mt19937 random(7);
    std::vector<std::uint32_t> place(mesh.positions.size());
    std::iota(place.begin(), place.end(), 0);
    std::shuffle(place.begin(), place.end(), random);
    TriangleMesh result = mesh;
    for (std::size_t v = 0; v < place.size(); ++v)
        result.positions[place[v]] = mesh.positions[v];
    for (Triangle& t : result.triangles) {
        for (std::uint32_t& v : t)
            v = place[v];
        std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    }
    std::shuffle(result.triangles.begin(), result.triangles.end(), random);
    return result;
}

/// How often it can be undone; the mesh becomes what is left.
int undo_all(TriangleMesh& mesh, std::vector<Midpoint>& midpoints) {
    int times = 0;
    while (undo_subdivision(mesh.positions, mesh.triangles, midpoints))
        ++times;
    return times;
}

std::vector<std::array<double, 9>> corners_of(const TriangleMesh& mesh) {
    std::vector<std::array<double, 9>> all;
    for (Triangle t : mesh.triangles) {
        const auto is_before = [&](std::uint32_t a, std::uint32_t b) {
            const Eigen::Vector3d &p = mesh.positions[a], &q = mesh.positions[b];
            return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
        };
        std::rotate(t.begin(), std::min_element(t.begin(), t.end(), is_before), t.end());
        std::array<double, 9> corners;
        for (int k = 0; k < 3; ++k)
            std::copy_n(mesh.positions[t[k]].data(), 3, corners.begin() + 3 * k);
        all.push_back(corners);
    }
    std::sort(all.begin(), all.end());
    return all;
}

TEST(Midpoints, AreTakenOutInOrder) {
    const TriangleMesh mesh = scan();
    for (const int times : {1, 2, 3}) {
        TriangleMesh cut = rounded_to_floats(subdivided(mesh, times));
        std::vector<Midpoint> midpoints;
        EXPECT_EQ(undo_all(cut, midpoints), times);
        EXPECT_EQ(cut.triangles, mesh.triangles);
        EXPECT_EQ(midpoints.size(), cut.positions.size() - mesh.positions.size());
    }
}

TEST(Midpoints, AreTakenOutOfMeshesOfAllKinds) {
    using namespace test_meshes;
    TriangleMesh two = scan();
    append(two, moved(scan(), {3, 0, 0}));
    TriangleMesh flipped = scan();
    flip_triangles(flipped, 5);
    const TriangleMesh far_off = moved(scan(), {20, -30, 0});
    for (const TriangleMesh& mesh :
         {two, flipped, far_off, half_torus(30, 20).mesh, moebius_strip(60, 8)}) {
        TriangleMesh cut = shuffled(rounded_to_floats(subdivided(rounded_to_floats(mesh), 2)));
        std::vector<Midpoint> midpoints;
        EXPECT_EQ(undo_all(cut, midpoints), 2);
        EXPECT_TRUE(corners_of(cut) == corners_of(rounded_to_floats(mesh)));
    }
}

TEST(Midpoints, StayWhereNotAllTrianglesAreQuarters) {
    using namespace test_meshes;
    const auto stays = [](TriangleMesh mesh) {
        const TriangleMesh before = mesh;
        std::vector<Midpoint> midpoints;
        EXPECT_EQ(undo_all(mesh, midpoints), 0);
        EXPECT_EQ(mesh.triangles, before.triangles);
        EXPECT_TRUE(midpoints.empty());
    };
    stays(icosphere(5));
    stays(hills(40).mesh);
    stays(book(8));
    stays(star(8, false));
    const TriangleMesh cut = subdivided(scan(), 1);
    TriangleMesh moved = cut;
    moved.positions.back() += 1e-3 * Eigen::Vector3d::Ones();
    stays(moved);
    TriangleMesh open = cut;
    open.triangles.resize(open.triangles.size() - 5);
    open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 3);
    stays(open);
    TriangleMesh doubled = cut;
    doubled.triangles.insert(doubled.triangles.end(), cut.triangles.end() - 4,
                             cut.triangles.end());
    stays(doubled);
    TriangleMesh other = cut;
    append(other, icosphere(2));
    stays(other);
    TriangleMesh refined = scan();
    refine(refined, 1);
    stays(refined);
}

TEST(Midpoints, HaveTheMeansOfTheEndsOfTheirEdges) {
    const TriangleMesh mesh = scan(), cut = subdivided(mesh, 1);
    const Field before = helpers::complete_field(mesh), field = helpers::complete_field(cut);
    EXPECT_EQ(field.report.undone_subdivisions, 1);
    EXPECT_EQ(field.report.unreferenced_vertices, 0u);
    EXPECT_EQ(field.report.degenerate_triangles, 0u);
    EXPECT_EQ(field.scale.mean_edge, before.scale.mean_edge);
    EXPECT_EQ(field.scale.kernel_size, before.scale.kernel_size);
    const auto same = [](const auto& a, const auto& b, std::size_t v) { return a[v] == b[v]; };
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        EXPECT_TRUE(same(before.normals, field.normals, v)) << v;
        EXPECT_TRUE(same(before.laplacian_normals, field.laplacian_normals, v)) << v;
        EXPECT_TRUE(same(before.curvature_derivatives, field.curvature_derivatives, v)) << v;
    }
    std::vector<Triangle> triangles = cut.triangles;
    std::vector<Midpoint> midpoints;
    ASSERT_TRUE(undo_subdivision(cut.positions, triangles, midpoints));
    for (const Midpoint& m : midpoints) {
        const auto [a, b] = m.ends;
        const std::uint32_t v = m.vertex;
        EXPECT_LT((field.normals[v] - (field.normals[a] + field.normals[b]).normalized()).norm(),
                  1e-6f);
        const Eigen::Vector3f laplacian =
            (field.laplacian_normals[a] + field.laplacian_normals[b]) / 2;
        EXPECT_LT((field.laplacian_normals[v] - laplacian).norm(), 1e-5f * laplacian.norm());
        EXPECT_FLOAT_EQ(field.kernel_sizes[v], (field.kernel_sizes[a] + field.kernel_sizes[b]) / 2);
        EXPECT_NEAR(field.shape_operators[v].trace(),
                    (field.shape_operators[a].trace() + field.shape_operators[b].trace()) / 2,
                    1e-4f);
    }
}

/// S̄(x, x) and C(x, x, x), x a vector in space.
struct Forms {
    double curvature, derivative;
};
Forms forms_along(const Field& field, std::uint32_t v, const Eigen::Vector3f& x) {
    const Eigen::Vector2d t = tangent_frame(field.normals[v])(x).cast<double>();
    const Eigen::Vector3d s = field.smooth_curvatures[v].cast<double>();
    const Eigen::Vector4d c = field.curvature_derivatives[v].cast<double>();
    const double u = t.x(), w = t.y();
    return {s[0] * u * u + 2 * s[1] * u * w + s[2] * w * w,
            c[0] * u * u * u + 3 * c[1] * u * u * w + 3 * c[2] * u * w * w + c[3] * w * w * w};
}

TEST(Midpoints, HaveDerivativesInFramesOfTheirOwn) {
    const TriangleMesh mesh = test_meshes::bumpy_sphere(5).mesh, cut = subdivided(mesh, 1);
    const Field field = helpers::complete_field(cut);
    std::vector<Triangle> triangles = cut.triangles;
    std::vector<Midpoint> midpoints;
    ASSERT_TRUE(undo_subdivision(cut.positions, triangles, midpoints));
    double wrong = 0, all = 0, wrong_derivative = 0, all_derivative = 0;
    for (const Midpoint& m : midpoints) {
        const TangentFrame frame = tangent_frame(field.normals[m.vertex]);
        for (const Eigen::Vector3f& x : {frame.u, frame.v, Eigen::Vector3f(frame.u + frame.v)}) {
            const Forms here = forms_along(field, m.vertex, x),
                        a = forms_along(field, m.ends[0], x), b = forms_along(field, m.ends[1], x);
            wrong += std::abs(here.curvature - (a.curvature + b.curvature) / 2);
            all += std::abs(here.curvature);
            wrong_derivative += std::abs(here.derivative - (a.derivative + b.derivative) / 2);
            all_derivative += std::abs(here.derivative);
        }
    }
    EXPECT_LT(wrong, 0.01 * all);
    EXPECT_LT(wrong_derivative, 0.01 * all_derivative);
}

TEST(Midpoints, ChangeNoLines) {
    const TriangleMesh mesh = rounded_to_floats(scan());
    const LineExtractor before(mesh, helpers::complete_field(mesh));
    for (const int times : {1, 2}) {
        const TriangleMesh cut = subdivided(mesh, times);
        const LineExtractor extractor(cut, helpers::complete_field(cut));
        for (const View& view : helpers::random_views(mesh, 4))
            EXPECT_TRUE(helpers::same_lines(helpers::extract(extractor, view, helpers::all_kinds()),
                                            helpers::extract(before, view, helpers::all_kinds())))
                << times;
    }
}

TEST(Midpoints, StayIfTheKernelIsSmallerThanThatOfTheMeshBefore) {
    const TriangleMesh mesh = scan(), cut = subdivided(mesh, 2);
    const double kernel = precompute(mesh).scale.kernel_size;
    PrecomputeOptions options;
    const int undone[] = {2, 1, 0};
    for (int i = 0; i < 3; ++i) {
        options.kernel_size = kernel * (1.01 / double(1 << i));
        EXPECT_EQ(precompute(cut, options).report.undone_subdivisions, undone[i]);
    }
}

/// As far as they make them smaller than 2.5 % of D.
TEST(Midpoints, StayOnFormsOfFewLargeTriangles) {
    const TriangleMesh form = test_meshes::icosphere(0);
    for (const int times : {3, 4, 5, 6}) {
        const Field field = precompute(subdivided(form, times));
        EXPECT_EQ(field.report.undone_subdivisions, std::max(0, times - 4));
        EXPECT_GT(field.scale.mean_edge, (times < 4 ? 0.025 : 0.0125) * field.scale.diagonal);
    }
}

/// The extractor's own field may be of a kernel for which nothing was undone.
TEST(Midpoints, OfKernelsForOneExtractorMayDiffer) {
    const TriangleMesh cut = subdivided(scan(), 1);
    PrecomputeOptions options;
    options.kernel_size = 0.3 * precompute(cut).scale.kernel_size;
    const Field fine = precompute(cut, options), coarse = precompute(cut);
    ASSERT_NE(fine.report.undone_subdivisions, coarse.report.undone_subdivisions);
    for (const auto& [own, other] : {std::pair(&fine, &coarse), std::pair(&coarse, &fine)}) {
        const LineExtractor extractor(cut, *own);
        const KernelLaplacian laplacian = extractor.laplacian_of(cut, *other);
        ExtractionScratch scratch;
        LineSet lines;
        extractor.extract(helpers::random_views(cut, 1)[0], LineStyle(), scratch, lines,
                          &laplacian);
        EXPECT_FALSE(lines.lines.empty());
    }
}

}  // namespace
