// SPDX-License-Identifier: GPL-3.0-or-later
// Lines against known curves: circles on a sphere, the zero set on a torus.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using helpers::extract;

constexpr double kPi = 3.14159265358979323846;

/// Exact normals: only lines are tested.
PrecomputeOptions sphere_options() {
    PrecomputeOptions options;
    options.normal_weighting = NormalWeighting::Max;
    options.normal_smoothing = NormalSmoothing::None;
    options.kernel_size = 0.15;
    options.skip_opposite_sheet = false;  // its weights fade around the sphere
    return options;
}

/// The silhouette of a sphere of radius R seen from distance d is the circle of radius
/// R √(1 − R²/d²) at height R²/d; from infinity the great circle.
double distance_to_silhouette(const Eigen::Vector3d& p, const Eigen::Vector3d& direction,
                              double height) {
    const double along = p.dot(direction), across = (p - along * direction).norm();
    return std::hypot(along - height, across - std::sqrt(1 - height * height));
}

void expect_silhouette(const View& view, const LineStyle& style, double tolerance) {
    const auto sphere = test_meshes::sphere(5);
    const LineExtractor extractor(sphere.mesh, precompute(sphere.mesh, sphere_options()));
    const LineSet lines = extract(extractor, view, style);
    const double height = view.w == 0 ? 0 : view.w / view.eye.norm();
    ASSERT_EQ(lines.lines.size(), 1u);
    EXPECT_TRUE(lines.lines[0].closed);
    double worst = 0;
    for (const LinePoint& p : lines.points)
        worst = std::max(worst, distance_to_silhouette(p.position.cast<double>(),
                                                       view.eye.normalized(), height));
    EXPECT_LT(worst, tolerance);
    const double circumference = 2 * kPi * std::sqrt(1 - height * height);
    const double diagonal = 2 * std::sqrt(3.0);
    EXPECT_NEAR(lines.lines[0].length * diagonal, circumference, 2e-3 * circumference);
}

const Eigen::Vector3d kDirection = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();

TEST(Sphere, ContoursAreSilhouetteCircles) {
    for (double distance : {1.3, 2.0, 10.0})
        expect_silhouette(View::perspective(distance * kDirection), helpers::all_contours(), 5e-4);
    expect_silhouette(View::orthographic(kDirection), helpers::all_contours(), 5e-4);
}

/// The paper's form ΔI = Δn·l vanishes on a sphere exactly where n·l does.
TEST(Sphere, LaplacianLinesCoincideWithTheSilhouette) {
    for (double distance : {1.3, 2.0, 10.0})
        expect_silhouette(View::perspective(distance * kDirection), helpers::all_laplacian_lines(),
                          2e-3);
    expect_silhouette(View::orthographic(kDirection), helpers::all_laplacian_lines(), 2e-3);
}

// ---- torus ----

using ZeroFunction = std::function<double(const test_meshes::SurfacePoint&)>;

/// From a grid much finer than the meshes.
std::vector<Eigen::Vector3d> zero_set(const ZeroFunction& f) {
    constexpr int kColumns = 2000, kRows = 1000;
    std::vector<double> values(std::size_t(kColumns) * kRows);
    std::vector<Eigen::Vector3d> positions(values.size()), zeros;
    for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i) {
            const auto p = test_meshes::closed_form_torus_point({}, 2 * kPi * i / kColumns,
                                                                2 * kPi * j / kRows);
            values[std::size_t(j * kColumns + i)] = f(p);
            positions[std::size_t(j * kColumns + i)] = p.position;
        }
    const auto add_crossing = [&](int a, int b) {
        const double fa = values[std::size_t(a)], fb = values[std::size_t(b)];
        if ((fa < 0) == (fb < 0)) return;
        const double t = fa / (fa - fb);
        zeros.push_back((1 - t) * positions[std::size_t(a)] + t * positions[std::size_t(b)]);
    };
    for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i) {
            add_crossing(j * kColumns + i, j * kColumns + (i + 1) % kColumns);
            add_crossing(j * kColumns + i, (j + 1) % kRows * kColumns + i);
        }
    return zeros;
}

/// Hausdorff distance; printed for docs/accuracy.md.
double hausdorff(const std::vector<Eigen::Vector3d>& truth, const LineSet& lines) {
    double truth_to_lines = 0, lines_to_truth = 0;
    for (const Eigen::Vector3d& p : truth)
        truth_to_lines = std::max(truth_to_lines, helpers::distance_to_lines(p, lines));
    for (const LinePoint& point : lines.points) {
        double nearest = 1e9;
        for (const Eigen::Vector3d& p : truth)
            nearest = std::min(nearest, (point.position.cast<double>() - p).squaredNorm());
        lines_to_truth = std::max(lines_to_truth, std::sqrt(nearest));
    }
    const double distance = std::max(truth_to_lines, lines_to_truth);
    std::printf("largest distance %.2g\n", distance);
    return distance;
}

LineSet torus_lines(int columns, double jitter, const View& view, const LineStyle& style) {
    const auto torus = test_meshes::torus(columns, columns / 2, jitter);
    return extract(LineExtractor(torus.mesh, precompute(torus.mesh)), view, style);
}

const Eigen::Vector3d kTorusEye(2.5, -3.5, 2.8);

ZeroFunction paper_form(const View& view) {
    return [=](const test_meshes::SurfacePoint& p) {
        return p.laplacian_normal.dot(view.eye - view.w * p.position);
    };
}

class TorusLines : public testing::TestWithParam<bool> {  // perspective?
protected:
    View view() const {
        return GetParam() ? View::perspective(kTorusEye) : View::orthographic(kTorusEye);
    }
};

INSTANTIATE_TEST_SUITE_P(Views, TorusLines, testing::Bool(), [](const auto& info) {
    return info.param ? "perspective" : "orthographic";
});

TEST_P(TorusLines, ConvergeToTheZeroSet) {
    const auto truth = zero_set(paper_form(view()));
    const auto distance = [&](int columns) {
        return hausdorff(truth, torus_lines(columns, 0, view(), helpers::all_laplacian_lines()));
    };
    const double coarse = distance(60), medium = distance(120), fine = distance(240);
    EXPECT_LT(medium, 0.6 * coarse);
    EXPECT_LT(fine, 0.8 * medium);
    EXPECT_LT(fine, 0.01);
}

TEST_P(TorusLines, StayNearTheZeroSetOnIrregularMeshes) {
    const auto truth = zero_set(paper_form(view()));
    const double distance =
        hausdorff(truth, torus_lines(240, 0.2, view(), helpers::all_laplacian_lines()));
    EXPECT_LT(distance, 0.09);
}

TEST_P(TorusLines, ContoursConvergeToo) {
    const View v = view();
    const auto truth = zero_set(
        [v](const test_meshes::SurfacePoint& p) { return p.normal.dot(v.eye - v.w * p.position); });
    const auto distance = [&](int columns) {
        return hausdorff(truth, torus_lines(columns, 0, v, helpers::all_contours()));
    };
    const double coarse = distance(60), fine = distance(120);
    EXPECT_LT(fine, 0.6 * coarse);
    EXPECT_LT(fine, 0.01);
}

TEST(ExactPointLight, IsTheTrueLaplacianOfTheIllumination) {
    for (double u : {0.2, 1.9, 4.0})
        for (double v : {0.4, 2.2, 3.9, 5.5}) {
            const auto p = test_meshes::closed_form_torus_point({}, u, v);
            const double exact =
                p.laplacian_normal.dot(kTorusEye - p.position) - p.shape_operator.trace();
            EXPECT_NEAR(exact, test_meshes::torus_illumination_laplacian({}, u, v, kTorusEye),
                        1e-10);
        }
}

TEST(EyeAtInfinity, IsTheLimitOfFarEyes) {
    const auto torus = test_meshes::torus(120, 60);
    const Field field = precompute(torus.mesh);
    const LineExtractor extractor(torus.mesh, field);
    const Eigen::Vector3d direction = kTorusEye.normalized();
    const LineSet limit =
        extract(extractor, View::orthographic(direction), helpers::all_crossings());
    double previous = 1;
    for (double distance : {10.0, 1e2, 1e4, 1e6}) {
        const View view = View::perspective(distance * field.scale.diagonal * direction);
        double worst = 0;
        for (const LinePoint& p : extract(extractor, view, helpers::all_crossings()).points)
            worst = std::max(worst, helpers::distance_to_lines(p.position.cast<double>(), limit));
        EXPECT_LT(worst, std::max(0.2 * previous, 2e-5)) << "distance " << distance;
        previous = worst;
    }
}

TEST(Views, DoNotChangeWithTheScaleOfTheHomogeneousEye) {
    const auto torus = test_meshes::torus(60, 30);
    const LineExtractor extractor(torus.mesh, precompute(torus.mesh));
    const LineSet lines = extract(extractor, View{kTorusEye, 1}, {});
    EXPECT_TRUE(helpers::same_lines(lines, extract(extractor, View{4 * kTorusEye, 4}, {})));
    const LineSet far = extract(extractor, View{kTorusEye, 0}, {});
    EXPECT_TRUE(helpers::same_lines(far, extract(extractor, View{8 * kTorusEye, 0}, {})));
}

// ---- made-up fields on the square [−1, 1]², seen from +z ----

/// ΔI = f(x, y), ∇I = (1, 0, 0); the kernel size is 0.5 everywhere.
LineSet lines_of(const Field& scales, const std::function<double(double x, double y)>& f,
                 const LineStyle& style) {
    const TriangleMesh square = test_meshes::plane(60);
    Field field = precompute(square);
    field.scale = scales.scale;
    for (std::size_t v = 0; v < field.normals.size(); ++v) {
        const Eigen::Vector3d& p = square.positions[v];
        field.laplacian_normals[v] = {0, 0, float(f(p.x(), p.y()))};
        field.shape_operators[v] = {};
        field.shape_operators[v].xz = 1;
        field.kernel_sizes[v] = 0.5f;
    }
    return extract(LineExtractor(square, field), View::orthographic(Eigen::Vector3d::UnitZ()),
                   style);
}

/// Where an adaptive kernel is half as large, so is the smoothing: slope = ‖∇ΔI‖ (h + σ²/2)^1.5
/// with both of that place.
TEST(Slope, FollowsTheAdaptiveKernelAndItsSmoothing) {
    Field scales;
    scales.scale = {std::sqrt(8.0), 0.1, 1.0, 0.8};  // √h = 1 and σ = 0.8, before adaptation
    const LineSet set = lines_of(
        scales, [](double x, double) { return 3 * (x - 0.01); }, helpers::all_laplacian_lines());
    ASSERT_EQ(set.lines.size(), 1u);
    EXPECT_NEAR(set.lines[0].slope, 3 * std::pow(0.25 + 0.16 / 2, 1.5), 1e-3);
}

TEST(ClosedLines, HaveTheSameWeightAllRound) {
    Field scales;
    scales.scale = {std::sqrt(8.0), 0.1, 0.5, 0};
    LineStyle style = helpers::all_laplacian_lines();
    style.full_slope = 0.25;  // twice the slope of the circle, which is 0.5³
    const LineSet set = lines_of(
        scales, [](double x, double y) { return std::hypot(x, y) - 0.61; }, style);
    ASSERT_EQ(set.lines.size(), 1u);
    EXPECT_TRUE(set.lines[0].closed);
    EXPECT_NEAR(set.lines[0].length * std::sqrt(8.0), 2 * kPi * 0.61, 0.01);
    for (const LinePoint& p : set.points)
        EXPECT_NEAR(p.weight, 0.5, 0.01);
}

}  // namespace
