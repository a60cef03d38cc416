// SPDX-License-Identifier: GPL-3.0-or-later
// Lines against known curves: circles on a sphere, zeros of made-up fields; and whole lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using helpers::extract;

/// The silhouette of a sphere of radius R seen from distance d is the circle of radius
/// R √(1 − R²/d²) at height R²/d; from infinity the great circle.
double distance_to_silhouette(const Eigen::Vector3d& p, const Eigen::Vector3d& direction,
                              double height) {
    const double along = p.dot(direction), across = (p - along * direction).norm();
    return std::hypot(along - height, across - std::sqrt(1 - height * height));
}

void expect_silhouette(const View& view, const LineStyle& style, double tolerance) {
    const auto sphere = test_meshes::sphere(5);
    const LineExtractor extractor(sphere.mesh,
                                  helpers::true_field(sphere, measure_scale(sphere.mesh)));
    const LineSet lines = extract(extractor, view, style);
    const double height = view.w == 0 ? 0 : view.w / view.eye.norm();
    ASSERT_EQ(lines.lines.size(), 1u);
    EXPECT_TRUE(lines.lines[0].closed);
    double worst = 0;
    for (const LinePoint& p : lines.points)
        worst = std::max(worst, distance_to_silhouette(p.position.cast<double>(),
                                                       view.eye.normalized(), height));
    EXPECT_LT(worst, tolerance);
    const double circumference = 2 * M_PI * std::sqrt(1 - height * height);
    const double diagonal = 2 * std::sqrt(3.0);
    EXPECT_NEAR(lines.lines[0].length * diagonal, circumference, 2e-3 * circumference);
}

const Eigen::Vector3d kDirection = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();

/// The paper's form ΔI = Δn·l vanishes on a sphere exactly where n·l does.
TEST(Sphere, ContoursAndLaplacianLinesAreSilhouetteCircles) {
    for (const auto& [style, tolerance] :
         {std::pair(helpers::all_contours(), 5e-4), {helpers::all_laplacian_lines(), 2e-3}}) {
        for (double distance : {1.3, 2.0, 10.0})
            expect_silhouette(View::perspective(distance * kDirection), style, tolerance);
        expect_silhouette(View::orthographic(kDirection), style, tolerance);
    }
}

const Eigen::Vector3d kTorusEye(2.5, -3.5, 2.8);

TEST(Views, DoNotChangeWithTheScaleOfTheHomogeneousEye) {
    const auto torus = test_meshes::torus(60, 30);
    const LineExtractor extractor(torus.mesh, precompute(torus.mesh));
    const LineSet lines = extract(extractor, View{kTorusEye, 1}, {});
    EXPECT_TRUE(helpers::same_lines(lines, extract(extractor, View{4 * kTorusEye, 4}, {})));
    const LineSet far = extract(extractor, View{kTorusEye, 0}, {});
    EXPECT_TRUE(helpers::same_lines(far, extract(extractor, View{8 * kTorusEye, 0}, {})));
}

// ---- made-up fields on the square [−1, 1]², seen from +z ----

/// ΔI = f(x, y), ∇I = (1, 0, −0.5), by a field with this √h and σ.
LineSet lines_of(const std::function<double(double x, double y)>& f, const LineStyle& style,
                 double kernel_size, double sigma) {
    const TriangleMesh square = test_meshes::plane(60);
    Field field = precompute(square);
    field.scale = {std::sqrt(8.0), 0.1, kernel_size, sigma};
    for (std::size_t v = 0; v < field.normals.size(); ++v) {
        const Eigen::Vector3d& p = square.positions[v];
        field.laplacian_normals[v] = {0, 0, float(f(p.x(), p.y()))};
        field.shape_operators[v] = {};
        field.shape_operators[v].xz = 1;
        field.shape_operators[v].zz = -0.5f;  // concave towards the eye
    }
    return extract(LineExtractor(square, field), View::orthographic(Eigen::Vector3d::UnitZ()),
                   style);
}

/// slope = ‖∇ΔI‖ (h + σ²/2)^1.5
TEST(Slope, FollowsTheKernelAndTheSmoothing) {
    const LineSet set = lines_of([](double x, double) { return 3 * (x - 0.01); },
                                 helpers::all_laplacian_lines(), 0.5, 0.4);
    ASSERT_EQ(set.lines.size(), 1u);
    EXPECT_NEAR(set.lines[0].slope, 3 * std::pow(0.25 + 0.16 / 2, 1.5), 1e-3);
}

TEST(ClosedLines, HaveTheSameWeightAllRound) {
    LineStyle style = helpers::all_laplacian_lines();
    style.full_slope = 0.25;  // twice the slope of the circle, which is 0.5³
    const LineSet set =
        lines_of([](double x, double y) { return std::hypot(x, y) - 0.61; }, style, 0.5, 0);
    ASSERT_EQ(set.lines.size(), 1u);
    EXPECT_TRUE(set.lines[0].closed);
    EXPECT_NEAR(set.lines[0].length * std::sqrt(8.0), 2 * M_PI * 0.61, 0.01);
    for (const LinePoint& p : set.points)
        EXPECT_NEAR(p.weight, 0.5, 0.01);
}

// ---- whole lines, see LineStyle::whole_lines

/// Of a line that comes to a point and turns back there by all but so many degrees: what is drawn
/// at the point.
float opacity_at_point(double degrees) {
    constexpr double kPoint = -0.303;
    const double half = degrees / 2 * M_PI / 180;
    LineStyle style = helpers::all_laplacian_lines();
    style.whole_lines = style.single_strokes = true;
    style.least_concavity = -1;
    const LineSet lines = lines_of(
        [&](double x, double y) {
            return 100 * (std::cos(half) * std::abs(y) - std::sin(half) * (x - kPoint));
        },
        style, 0.2, 0);
    EXPECT_GT(lines.points.size(), 50u);
    float opacity = 0;
    for (const LinePoint& p : lines.points)
        if ((p.position - Eigen::Vector3f(kPoint, 0, 0)).norm() < 0.02f)
            opacity = std::max(opacity, p.opacity);
    return opacity;
}

TEST(WholeLines, AreCutWhereTheyTurnBack) {
    EXPECT_EQ(opacity_at_point(130), 1);
    EXPECT_LT(opacity_at_point(20), 0.1);
}

float mean_length(const LineExtractor& extractor, LineKind kind, bool whole) {
    LineStyle style = helpers::only(kind);
    style.whole_lines = whole;
    const LineSet lines = extract(extractor, View::orthographic({0.3, 0.4, 1}), style);
    EXPECT_GT(lines.lines.size(), whole ? 0u : 3u);
    return helpers::total_length(lines) / float(lines.lines.size());
}

/// Tracing whole mends the dashes that texture cuts.
TEST(WholeLines, AreLongerOnANoisySurface) {
    const TriangleMesh mesh = test_meshes::with_noise(test_meshes::bumpy_sphere(5).mesh, 0.2, 3);
    const LineExtractor extractor(mesh, helpers::complete_field(mesh));
    for (const LineKind kind :
         {LineKind::Laplacian, LineKind::SuggestiveContour, LineKind::PhoticExtremum})
        EXPECT_GT(mean_length(extractor, kind, true), 1.1f * mean_length(extractor, kind, false))
            << int(kind);
}

}  // namespace
