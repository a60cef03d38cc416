// SPDX-License-Identifier: GPL-3.0-or-later
// Fields and lines against those of reference.h, which has them from the paper's formulas alone.
#include "reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "helpers.h"
#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using helpers::relative_error;
using helpers::uncorrected_options;

TEST(ReferenceField, HasTheSameNormals) {
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    EXPECT_LT(
        relative_error(precompute(mesh, uncorrected_options(0)).normals, reference::normals(mesh)),
        1e-7);
}

TEST(ReferenceField, HasTheSameSmoothedNormals) {
    for (const char* name : {"torus_jittered", "hills"}) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        PrecomputeOptions options = uncorrected_options(0);
        options.normal_smoothing = NormalSmoothing::Gaussian;
        options.normal_sigma = 1.3;
        const Field field = precompute(mesh, options);
        const double sigma = 1.3 * reference::mean_edge(mesh);
        const auto expected = reference::smoothed(mesh, reference::normals(mesh), sigma);
        EXPECT_LT(relative_error(field.normals, expected), 1e-6) << name;
        EXPECT_NEAR(field.scale.normal_sigma, sigma, 1e-9);
    }
}

/// Two parallel sheets, bent so that Δn is not zero on them.
TriangleMesh bent_wall() {
    return test_meshes::mapped(test_meshes::parallel_sheets(48, 0.12), [](Eigen::Vector3d& p) {
        p.z() += 0.2 * std::sin(2 * p.x() + p.y());
    });
}

/// Of small kernels, which are summed directly, and of large ones, by a grid.
TEST(ReferenceField, HasTheSameLaplacianAsAccuratelyAsAskedFor) {
    for (const TriangleMesh& mesh :
         {test_meshes::with_noise(test_meshes::torus(60, 30).mesh, 0.1),
          test_meshes::moved(test_meshes::torus(60, 30, 0.2).mesh, {4000, -3000, 1000}),
          test_meshes::hills(40, 0.2).mesh, bent_wall()})
        for (const double size : {2., 12.})
            for (const bool skip : {false, true}) {
                PrecomputeOptions options = uncorrected_options(size * reference::mean_edge(mesh));
                options.skip_opposite_sheet = skip;
                const auto expected =
                    reference::laplacian(mesh, reference::normals(mesh), options.kernel_size, skip);
                for (const double accuracy : {1e-2, 1e-3, 1e-5}) {
                    options.accuracy = accuracy;
                    EXPECT_LT(relative_error(precompute(mesh, options).laplacian_normals, expected),
                              1.02 * accuracy + 4e-6)
                        << size << ' ' << skip;
                }
            }
}

TEST(ReferenceField, HasTheSameScale) {
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    const FieldScale scale = precompute(mesh).scale, measured = measure_scale(mesh);
    const double edge = reference::mean_edge(mesh), diagonal = reference::diagonal(mesh);
    EXPECT_NEAR(scale.mean_edge, edge, 1e-12);
    EXPECT_NEAR(scale.diagonal, diagonal, 1e-12);
    EXPECT_NEAR(scale.kernel_size, std::max(edge, 0.0045 * diagonal), 1e-9);
    EXPECT_EQ(scale.normal_sigma, 0);
    EXPECT_DOUBLE_EQ(measured.kernel_size, scale.kernel_size);
    EXPECT_EQ(measured.normal_sigma, 0) << "known only once the surface is looked at";
    const FieldScale fine = measure_scale(test_meshes::sphere(7).mesh);
    EXPECT_DOUBLE_EQ(fine.kernel_size, 0.0045 * fine.diagonal);
}

// ---- lines

/// Also backwards, or from another start.
bool same_points(const LinePoint* points, const reference::Line& line, double diagonal) {
    const std::size_t count = line.points.size(), period = line.closed ? count - 1 : count;
    const auto same = [&](const LinePoint& p, std::size_t i) {
        return (p.position.cast<double>() - line.points[i]).norm() <= 5e-6 * diagonal &&
               std::abs(double(p.gradient) - line.gradients[i]) <= 1e-4 * (1 + line.gradients[i]);
    };
    for (std::size_t shift = 0; shift < (line.closed ? period : 1); ++shift)
        for (const bool backwards : {false, true}) {
            std::size_t i = 0;
            for (; i < count; ++i) {
                const std::size_t j = backwards ? count - 1 - i : i;
                if (!same(points[i], line.closed ? (j + shift) % period : j)) break;
            }
            if (i == count) return true;
        }
    return false;
}

bool is_same(const Polyline& line, const LinePoint* points, const reference::Line& other,
             double diagonal) {
    const auto same = [](float x, double y) { return std::abs(double(x) - y) <= 1e-4 * (1 + y); };
    return line.count == other.points.size() && line.closed == other.closed &&
           same(line.length, other.length) && same(line.strength, other.strength) &&
           (line.kind != LineKind::Laplacian || same(line.slope, other.slope)) &&
           same_points(points, other, diagonal);
}

struct Count {
    std::size_t lines = 0, unlike = 0;  // the core's, and those that only one of the two has
};

void compare(const LineSet& lines, std::vector<reference::Line> expected, double diagonal,
             Count& count) {
    count.lines += lines.lines.size();
    for (const Polyline& line : lines.lines) {
        const auto like = std::find_if(expected.begin(), expected.end(), [&](const auto& other) {
            return is_same(line, &lines.points[line.first], other, diagonal);
        });
        if (like != expected.end())
            expected.erase(like);
        else
            ++count.unlike;
    }
    count.unlike += expected.size();
}

/// The paper's t and τ alone, all thresholds, and none.
std::vector<LineStyle> styles() {
    LineStyle none = helpers::all_crossings(), paper = none, all = none;
    paper.gradient_threshold = all.gradient_threshold = LineStyle().gradient_threshold;
    paper.strength_threshold = all.strength_threshold = 0.1;
    all.reject_phantoms = true;
    all.segment_slope = LineStyle().segment_slope;
    all.line_slope = LineStyle().line_slope;
    all.shortest_line = all.shortest_contour = 0.05;
    all.least_facing = 0.1;
    for (LineStyle* style : {&none, &paper, &all}) {
        style->fading = style->end_length = 0;
        style->suggestive_slope = 0;
    }
    return {none, paper, all};
}

class ReferenceLines : public testing::TestWithParam<LineKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, ReferenceLines,
                         testing::Values(LineKind::Laplacian, LineKind::Contour,
                                         LineKind::SuggestiveContour,
                                         LineKind::SuggestiveHighlight),
                         [](const auto& info) { return std::string(describe(info.param).key); });

/// But for few, of which rounding decides where a function is nearly zero at a vertex.
TEST_P(ReferenceLines, AreTheSame) {
    for (const char* name : {"bumpy_sphere", "torus_jittered", "hills"}) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        const Field field = helpers::complete_field(mesh);
        const LineExtractor extractor(mesh, field);
        std::vector<View> views = helpers::random_views(mesh, 12);
        views[0].light = views[1].light = Eigen::Vector3d(1, -2, 3);
        for (LineStyle style : styles()) {
            style.shows = only_kinds({GetParam()});
            Count count;
            for (const View& view : views)
                compare(helpers::extract(extractor, view, style),
                        reference::zero_lines(mesh, field, view, style, GetParam()),
                        field.scale.diagonal, count);
            EXPECT_GT(count.lines, 5u) << name;
            EXPECT_LE(count.unlike, count.lines / 50) << name << ", of " << count.lines;
        }
    }
}

}  // namespace
