// SPDX-License-Identifier: GPL-3.0-or-later
// The curvatures behind suggestive contours against smooth surfaces: S and its derivative C, and
// the derivative of the radial curvature against differences on a torus.
#include "suggestive_contours.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "generators.h"

namespace {

using namespace benchmarks;
using Eigen::Vector3d;
using Eigen::Vector3f;
using test_meshes::AnalyticMesh;
using test_meshes::SurfacePoint;

constexpr double kLarge = 1, kSmall = 0.4;  // radii of the torus

std::vector<Vector3f> true_normals(const AnalyticMesh& surface) {
    std::vector<Vector3f> normals;
    for (const SurfacePoint& p : surface.truth)
        normals.push_back(p.normal.cast<float>());
    return normals;
}

Eigen::Matrix3d shape_operator(const VertexCurvature& c) {
    Eigen::Matrix3d s = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 2; ++i) {
        const Vector3d d = c.directions[i].cast<double>();
        s += double(c.curvatures[i]) * d * d.transpose();
    }
    return s;
}

/// C(x, x, x), with x in space.
double cubic(const VertexCurvature& c, const Vector3d& x) {
    const double a = c.directions[0].cast<double>().dot(x),
                 b = c.directions[1].cast<double>().dot(x);
    return double(c.derivative[0]) * a * a * a + 3 * double(c.derivative[1]) * a * a * b +
           3 * double(c.derivative[2]) * a * b * b + double(c.derivative[3]) * b * b * b;
}

/// √(Σ (a − b)² / Σ b²)
class RelativeError {
public:
    void add(double a, double b) {
        difference_ += (a - b) * (a - b);
        size_ += b * b;
    }
    double value() const { return std::sqrt(difference_ / size_); }

private:
    double difference_ = 0, size_ = 0;
};

/// A place on the torus, u around the axis and v around the tube, with the directions of both.
struct TorusPlace {
    double u, v;

    explicit TorusPlace(const Vector3d& p)
        : u(std::atan2(p.y(), p.x())), v(std::atan2(p.z(), std::hypot(p.x(), p.y()) - kLarge)) {}

    double ring() const { return kLarge + kSmall * std::cos(v); }
    Vector3d along_ring() const { return {-std::sin(u), std::cos(u), 0}; }
    Vector3d along_tube() const {
        return {-std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v)};
    }
    SurfacePoint moved(const Vector3d& step) const {
        return test_meshes::closed_form_torus_point({kLarge, kSmall},
                                                    u + along_ring().dot(step) / ring(),
                                                    v + along_tube().dot(step) / kSmall);
    }
};

/// Towards the eye along the surface, of unit length.
Vector3d radial_direction(const SurfacePoint& p, const Vector3d& eye) {
    const Vector3d l = eye - p.position;
    return (l - l.dot(p.normal) * p.normal).normalized();
}

double radial_curvature(const SurfacePoint& p, const Vector3d& eye) {
    const Vector3d w = radial_direction(p, eye);
    return w.dot(p.shape_operator * w);
}

TEST(VertexCurvatures, OfASphereAreOneOverItsRadiusEverywhere) {
    const AnalyticMesh sphere = test_meshes::sphere(4, 5);
    for (const VertexCurvature& c :
         vertex_curvatures(PlainMesh(sphere.mesh), true_normals(sphere))) {
        for (float k : c.curvatures)
            EXPECT_NEAR(k, 0.2, 1e-3);
        for (float d : c.derivative)
            EXPECT_NEAR(d, 0, 2e-3);
    }
}

TEST(VertexCurvatures, AreThoseOfATorus) {
    for (const double jitter : {0., 0.15}) {
        const AnalyticMesh torus = test_meshes::torus(160, 80, jitter, {kLarge, kSmall});
        const auto curvatures = vertex_curvatures(PlainMesh(torus.mesh), true_normals(torus));
        RelativeError tensor, derivative;
        for (std::size_t i = 0; i < curvatures.size(); ++i) {
            const SurfacePoint& truth = torus.truth[i];
            const Eigen::Matrix3d s = shape_operator(curvatures[i]);
            for (int k = 0; k < 9; ++k)
                tensor.add(s(k), truth.shape_operator(k));
            // Only the curvature of the rings changes, and only along the tube.
            const TorusPlace place(truth.position);
            const double change =
                -kLarge * std::sin(place.v) / (kSmall * place.ring() * place.ring());
            const Vector3d across = (place.along_ring() + place.along_tube()) / std::sqrt(2.);
            derivative.add(cubic(curvatures[i], place.along_ring()), 0);
            derivative.add(cubic(curvatures[i], place.along_tube()), 0);
            derivative.add(cubic(curvatures[i], across), 3 * change / std::sqrt(8.));
        }
        EXPECT_LT(tensor.value(), 0.02) << "jitter " << jitter;
        EXPECT_LT(derivative.value(), jitter > 0 ? 0.2 : 0.02) << "jitter " << jitter;
    }
}

TEST(SuggestiveContours, KnowHowTheRadialCurvatureChangesTowardsTheEye) {
    const AnalyticMesh torus = test_meshes::torus(320, 160, 0, {kLarge, kSmall});
    const auto normals = true_normals(torus);
    const auto curvatures = vertex_curvatures(PlainMesh(torus.mesh), normals);
    const Vector3d eye(1.5, -2.5, 2);
    RelativeError curvature, derivative;
    int compared = 0;
    for (std::size_t i = 0; i < curvatures.size(); ++i) {
        const SurfacePoint& truth = torus.truth[i];
        const double expected = radial_curvature(truth, eye);
        const auto seen = SuggestiveContours::look((eye - truth.position).cast<float>(), normals[i],
                                                   curvatures[i], 0);
        const Vector3d w = radial_direction(truth, eye);
        if (seen.facing < 0.1 || (eye - truth.position).cross(truth.normal).norm() < 0.1) continue;
        curvature.add(seen.curvature, expected);
        if (std::abs(expected) > 0.05) continue;  // the formula holds where κ_r = 0
        const TorusPlace place(truth.position);
        const double step = 1e-4;
        derivative.add(seen.above_threshold, (radial_curvature(place.moved(step * w), eye) -
                                              radial_curvature(place.moved(-step * w), eye)) /
                                                 (2 * step));
        ++compared;
    }
    EXPECT_GT(compared, 100);
    EXPECT_LT(curvature.value(), 0.01);
    EXPECT_LT(derivative.value(), 0.05);
}

TEST(SuggestiveContours, AreWhereTheRadialCurvatureIsZeroAndRises) {
    const AnalyticMesh torus = test_meshes::torus(320, 160, 0, {kLarge, kSmall});
    const PlainMesh mesh(torus.mesh);
    const auto normals = true_normals(torus);
    const Vector3d eye(1.5, -2.5, 2);
    SuggestiveContours contours(mesh, normals);
    std::vector<Vector3f> segments;
    contours.extract(laplacian_lines::View::perspective(eye), segments);
    EXPECT_GT(segments.size(), 100u);
    for (const Vector3f& p : segments) {
        const TorusPlace place(p.cast<double>());
        const SurfacePoint here = place.moved(Vector3d::Zero());
        EXPECT_NEAR(radial_curvature(here, eye), 0, 0.05);
        EXPECT_GT(here.normal.dot(eye - here.position), 0);
        const Vector3d w = radial_direction(here, eye);
        EXPECT_GT(radial_curvature(place.moved(0.01 * w), eye),
                  radial_curvature(place.moved(-0.01 * w), eye));
    }
}

}  // namespace
