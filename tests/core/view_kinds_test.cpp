// SPDX-License-Identifier: GPL-3.0-or-later
// Suggestive contours, apparent ridges and photic extrema: functions against finite differences on
// a torus, and nothing to draw.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "helpers.h"
#include "laplacian_lines/tangent_frame.h"
#include "plain_kinds.h"

namespace {

using namespace laplacian_lines;
using Eigen::Vector3d;
using reference::KindVertex;

constexpr LineKind kKinds[] = {LineKind::SuggestiveContour, LineKind::SuggestiveHighlight,
                               LineKind::ApparentRidge, LineKind::PhoticExtremum};

test_meshes::SurfacePoint point(double u, double v) {
    return test_meshes::torus_point({1, 0.4}, u, v);
}

KindVertex vertex(const test_meshes::SurfacePoint& truth) {
    KindVertex p;
    p.position = truth.position.cast<float>();
    p.normal = truth.normal.cast<float>();
    p.curvature = helpers::curvature_entries(truth.shape_operator, p.normal).cast<float>();
    const TangentFrame frame = tangent_frame(p.normal);
    const auto c = [&](const Eigen::Vector3f& x, const Eigen::Vector3f& y,
                       const Eigen::Vector3f& z) {
        float sum = 0;
        for (int i = 0; i < 3; ++i)
            sum += x[i] * y.dot(truth.shape_derivative[std::size_t(i)].cast<float>() * z);
        return sum;
    };
    p.derivative = {c(frame.u, frame.u, frame.u), c(frame.u, frame.u, frame.v),
                    c(frame.u, frame.v, frame.v), c(frame.v, frame.v, frame.v)};
    return p;
}

/// Along a tangent of the torus, central differences.
template <class Function>
double difference(const Function& f, double u, double v, const Vector3d& along) {
    constexpr double step = 1e-4;
    const Vector3d p = point(u, v).position;
    const Vector3d by_u = (point(u + step, v).position - p) / step,
                   by_v = (point(u, v + step).position - p) / step;
    const double du = along.dot(by_u) / by_u.squaredNorm(),
                 dv = along.dot(by_v) / by_v.squaredNorm();
    return (f(point(u + step * du, v + step * dv)) - f(point(u - step * du, v - step * dv))) /
           (2 * step);
}

/// The largest singular value of S P⁻¹, P the projection of the tangent plane along the sight.
double apparent(const test_meshes::SurfacePoint& p, const Vector3d& eye, double w) {
    const Vector3d sight = (eye - w * p.position).normalized();
    const double cosine = p.normal.dot(sight);
    const Vector3d along = (sight - cosine * p.normal).normalized();
    const Eigen::Matrix3d to_surface =
        Eigen::Matrix3d::Identity() + (1 / cosine - 1) * along * along.transpose();
    return (p.shape_operator * to_surface).jacobiSvd().singularValues()[0];
}

template <class Test>
void for_many_points(const Test& test) {
    int count = 0;
    for (int i = 0; i < 400; ++i) {
        const double u = 0.37 * i, v = 1.13 * i, w = i % 3 == 0 ? 0 : 1;
        const Vector3d eye = Vector3d(std::sin(0.7 * i), std::cos(1.9 * i), 1.2) * (w > 0 ? 3 : 1);
        const auto p = point(u, v);
        if (p.normal.dot((eye - w * p.position).normalized()) < 0.2) continue;
        test(u, v, eye, w);
        ++count;
    }
    EXPECT_GT(count, 100);
}

TEST(ViewKinds, ApparentRidgesAreOfTheDerivativeOfTheProjectedCurvature) {
    for_many_points([](double u, double v, const Vector3d& eye, double w) {
        const auto found =
            reference::apparent_curvature(vertex(point(u, v)), eye.cast<float>(), float(w));
        const auto q = [&](const test_meshes::SurfacePoint& p) { return apparent(p, eye, w); };
        const double true_q = q(point(u, v));
        EXPECT_NEAR(found.q, true_q, 1e-4 * true_q);
        const double derivative = difference(q, u, v, found.direction.cast<double>());
        EXPECT_NEAR(found.derivative, derivative, 2e-3 * (1 + std::abs(derivative)))
            << u << ", " << v << ", w " << w;
    });
}

TEST(ViewKinds, PhoticExtremaAreOfTheDerivativeOfTheGradient) {
    for_many_points([](double u, double v, const Vector3d& light, double w) {
        const auto gradient = [&](const test_meshes::SurfacePoint& p) -> Vector3d {
            return p.shape_operator * (light - w * p.position);
        };
        const auto half_square = [&](const test_meshes::SurfacePoint& p) {
            return gradient(p).squaredNorm() / 2;
        };
        const double derivative = difference(half_square, u, v, gradient(point(u, v)));
        const float found = reference::photic(vertex(point(u, v)), light.cast<float>(), float(w));
        EXPECT_NEAR(found, derivative, 2e-3 * (1 + std::abs(derivative)));
    });
}

TEST(ViewKinds, RadialCurvatureIsThatOfTheSectionTowardsTheEye) {
    for_many_points([](double u, double v, const Vector3d& eye, double w) {
        const auto p = point(u, v);
        const Vector3d sight = eye - w * p.position;
        const Vector3d tangent = sight - sight.dot(p.normal) * p.normal;
        const auto height = [&](const test_meshes::SurfacePoint& q) {
            return tangent.dot(q.normal);
        };
        const float found = reference::radial(vertex(p), eye.cast<float>(), float(w));
        EXPECT_NEAR(found, difference(height, u, v, tangent), 1e-3 * (1 + std::abs(found)));
    });
}

/// Without the help of thresholds, but for photic extrema.
TEST(ViewKinds, DrawNothingOnASphere) {
    const auto sphere = test_meshes::sphere(5);
    const LineExtractor extractor(sphere.mesh, helpers::complete_field(sphere.mesh));
    std::size_t photic = 0;
    for (const View& view : helpers::random_views(sphere.mesh, 10)) {
        const LineSet all =
            helpers::extract(extractor, view, helpers::all_crossings_of_all_kinds());
        for (const Polyline& line : all.lines) {
            photic += line.kind == LineKind::PhoticExtremum;
            for (const LineKind kind : {LineKind::SuggestiveContour, LineKind::SuggestiveHighlight,
                                        LineKind::ApparentRidge})
                EXPECT_NE(line.kind, kind) << describe(kind).key;
        }
        const LineStyle style = helpers::only(LineKind::PhoticExtremum);
        EXPECT_TRUE(helpers::extract(extractor, view, style).lines.empty());
    }
    EXPECT_GT(photic, 5u);
}

TEST(ViewKinds, AreLeftOutWhereTheyAreFlat) {
    const auto surface = test_meshes::bumpy_sphere(4, 0.15);
    const LineExtractor extractor(surface.mesh, helpers::complete_field(surface.mesh));
    const View view = View::perspective({3, 2, 4});
    for (const auto& [kind, slope] :
         {std::pair(LineKind::SuggestiveContour, &LineStyle::suggestive_slope),
          {LineKind::ApparentRidge, &LineStyle::apparent_slope},
          {LineKind::PhoticExtremum, &LineStyle::photic_slope}}) {
        LineStyle style = helpers::all_crossings_of_all_kinds();
        style.shows = helpers::only(kind).shows;
        EXPECT_FALSE(helpers::extract(extractor, view, style).lines.empty());
        style.*slope = 1e4;
        EXPECT_TRUE(helpers::extract(extractor, view, style).lines.empty()) << describe(kind).key;
    }
}

TEST(ViewKinds, DrawNothingOnAPlane) {
    const TriangleMesh& plane = test_meshes::mesh_named("plane").mesh;
    const LineExtractor extractor(plane, helpers::complete_field(plane));
    for (const View& view : helpers::random_views(plane, 10))
        for (const LineKind kind : kKinds)
            EXPECT_EQ(helpers::extract(extractor, view, helpers::only(kind)).lines.size(), 0u)
                << describe(kind).key;
}

}  // namespace
