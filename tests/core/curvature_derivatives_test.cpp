// SPDX-License-Identifier: GPL-3.0-or-later
// C = ∇S, its symmetries, and what it must not depend on. For accuracy see
// smooth_curvatures_test.cpp, which has the same fields.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/tangent_frame.h"
#include "plain_derivatives.h"

namespace {

using namespace laplacian_lines;
using test_meshes::AnalyticMesh;

PrecomputeOptions with_derivatives() {
    PrecomputeOptions options;
    options.curvature_derivatives = true;
    return options;
}

Field compute(const TriangleMesh& mesh) {
    return precompute(mesh, with_derivatives());
}

TEST(TangentFrame, IsOrthonormalAndRightHanded) {
    for (int i = 0; i < 2000; ++i) {
        const double z = i < 3 ? i - 1. : std::sin(1. + i), angle = 7.3 * i;
        const double ring = std::sqrt(std::max(0., 1 - z * z));
        const Eigen::Vector3f n =
            Eigen::Vector3d(ring * std::cos(angle), ring * std::sin(angle), z).cast<float>();
        const TangentFrame frame = tangent_frame(n);
        EXPECT_NEAR(frame.u.norm(), 1, 1e-6);
        EXPECT_NEAR(frame.v.norm(), 1, 1e-6);
        EXPECT_LT((frame.u.cross(frame.v) - n).norm(), 1e-6) << n.transpose();
    }
}

TEST(CurvatureDerivatives, OfTheTruthAreThoseOfClosedFormulas) {
    for (const double u : {0.3, 2., 5.})
        for (const double v : {0.1, 1.5, 4.}) {
            const auto a = test_meshes::torus_point({1, 0.4}, u, v);
            const auto b = test_meshes::closed_form_torus_point({1, 0.4}, u, v);
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_LT(
                    (a.shape_derivative[std::size_t(axis)] - b.shape_derivative[std::size_t(axis)])
                        .norm(),
                    1e-9);
        }
}

/// Codazzi: four numbers hold it.
TEST(CurvatureDerivatives, OfTheTruthAreSymmetric) {
    for (const AnalyticMesh& surface : {test_meshes::bumpy_sphere(2), test_meshes::hills(8)})
        for (const auto& point : surface.truth)
            for (std::size_t i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    for (int k = 0; k < 3; ++k) {
                        const auto& c = point.shape_derivative;
                        EXPECT_NEAR(c[i](j, k), c[std::size_t(j)](int(i), k), 1e-9);
                        EXPECT_NEAR(c[i](j, k), c[i](k, j), 1e-9);
                    }
}

TEST(CurvatureDerivatives, AreThoseOfPlainSums) {
    const AnalyticMesh surfaces[] = {test_meshes::torus(50, 25, 0.25),
                                     test_meshes::half_torus(30, 30),
                                     test_meshes::bumpy_sphere(4, 0.15)};
    for (const AnalyticMesh& surface : surfaces)
        for (const KernelMode mode : {KernelMode::Uniform, KernelMode::Adaptive}) {
            PrecomputeOptions options = with_derivatives();
            options.kernel_mode = mode;
            const Field field = precompute(surface.mesh, options);
            const auto plain = reference::curvature_derivatives(surface.mesh, field);
            double error = 0, size = 0, smooth_error = 0, smooth_size = 0;
            for (std::size_t v = 0; v < surface.truth.size(); ++v) {
                const Eigen::Vector4d c = field.curvature_derivatives[v].cast<double>();
                error += helpers::squared_size(c - plain.derivatives[v]);
                size += helpers::squared_size(plain.derivatives[v]);
                const Eigen::Vector3d s = field.smooth_curvatures[v].cast<double>();
                smooth_error += (s - plain.curvatures[v]).squaredNorm();
                smooth_size += plain.curvatures[v].squaredNorm();
            }
            EXPECT_LT(std::sqrt(error / size), 3e-6);
            EXPECT_LT(std::sqrt(smooth_error / smooth_size), 3e-6);
        }
}

/// For S linear in the place, up to borders, and on a lone triangle far smaller than the fit, with
/// differences within it.
TEST(CurvatureDerivatives, AreExactOfLinearShapeOperators) {
    TriangleMesh mesh = test_meshes::plane(20, 0.3);
    TriangleMesh small;
    small.positions = {{3, 0, 0}, {3.002, 0, 0}, {3, 0.003, 0}};
    small.triangles = {{0, 1, 2}};
    test_meshes::append(mesh, small);
    Field field = precompute(mesh);
    const Eigen::Vector4f c(3, -2, 1, 0.5f);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        ASSERT_GT(field.normals[v].z(), 0.999f);
        field.normals[v] = Eigen::Vector3f::UnitZ();
        const Eigen::Vector3f p = mesh.positions[v].cast<float>();
        ShapeOperator& s = field.shape_operators[v];
        s = {};
        s.xx = 0.3f + c[0] * p.x() + c[1] * p.y();
        s.xy = c[1] * p.x() + c[2] * p.y();
        s.yy = 0.1f + c[2] * p.x() + c[3] * p.y();
    }
    add_curvature_derivatives(mesh, field);
    const std::size_t last = mesh.positions.size() - 3;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        EXPECT_LT((field.curvature_derivatives[v] - c).norm(), v < last ? 1e-4 : 1e-2) << v;
}

TEST(CurvatureDerivatives, AreNoneOnPlanesAndSpheres) {
    const Field plane = compute(test_meshes::mesh_named("plane").mesh);
    for (const Eigen::Vector4f& c : plane.curvature_derivatives)
        EXPECT_LT(c.norm(), 1e-4);
    const double radius = 5;
    const Field sphere = compute(test_meshes::sphere(5, radius).mesh);
    double sum = 0;
    for (const Eigen::Vector4f& c : sphere.curvature_derivatives)
        sum += helpers::squared_size(c.cast<double>()) * std::pow(radius, 4);
    EXPECT_LT(std::sqrt(sum / double(sphere.normals.size())), 0.05);
}

TEST(CurvatureDerivatives, MoveAndScaleWithTheMesh) {
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    const Field field = compute(mesh);
    for (const double scale : {1e-4, 1., 1e5}) {
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
        TriangleMesh moved = mesh;
        for (Eigen::Vector3d& p : moved.positions)
            p = scale * (turn * p + Eigen::Vector3d(3, -1, 2));
        const Field other = compute(moved);
        double error = 0, size = 0;
        for (std::size_t v = 0; v < field.normals.size(); ++v) {
            const TangentFrame frame = tangent_frame(field.normals[v]),
                               moved_frame = tangent_frame(other.normals[v]);
            const Eigen::Vector3f u = turn.cast<float>() * frame.u;
            const float c = moved_frame.u.dot(u), s = moved_frame.v.dot(u);
            const auto cubic = [](const Eigen::Vector4f& f, float x, float y) {
                return f[0] * x * x * x + 3 * f[1] * x * x * y + 3 * f[2] * x * y * y +
                       f[3] * y * y * y;
            };
            for (const float angle : {0.f, 0.7f, 1.9f, 2.6f}) {
                const float x = std::cos(angle), y = std::sin(angle);
                const double expected = cubic(field.curvature_derivatives[v], x, y);
                const double got =
                    scale * scale *
                    cubic(other.curvature_derivatives[v], c * x - s * y, s * x + c * y);
                error += (got - expected) * (got - expected);
                size += expected * expected;
            }
        }
        EXPECT_LT(std::sqrt(error / size), 1e-3) << scale;
    }
}

TEST(CurvatureDerivatives, AreTheSameAddedLater) {
    for (const char* name : {"bumpy_sphere", "dirty_torus", "half_torus"}) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        Field later = precompute(mesh);
        EXPECT_TRUE(later.curvature_derivatives.empty());
        add_curvature_derivatives(mesh, later);
        EXPECT_TRUE(helpers::same_fields(later, compute(mesh))) << name;
        add_curvature_derivatives(mesh, later);
        EXPECT_TRUE(helpers::same_fields(later, compute(mesh))) << name;
    }
}

TEST(CurvatureDerivatives, OfVerticesOfCutsAreThoseAcrossThem) {
    const TriangleMesh whole = test_meshes::torus(40, 20).mesh;
    const TriangleMesh apart = test_meshes::cut_apart(whole);
    const Field expected = compute(whole), field = compute(apart);
    for (std::size_t t = 0; t < whole.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_LT((field.curvature_derivatives[apart.triangles[t][k]] -
                       expected.curvature_derivatives[whole.triangles[t][k]])
                          .norm(),
                      1e-2);
    Field later = precompute(apart);
    add_curvature_derivatives(apart, later);
    EXPECT_TRUE(helpers::same_fields(later, field));
}

TEST(CurvatureDerivatives, AreFiniteOnAnyMesh) {
    for (const auto* entries : {&test_meshes::all_entries(), &test_meshes::wild_entries()})
        for (const test_meshes::MeshEntry& entry : *entries) {
            const test_meshes::TestMesh& mesh = entry.get();
            if (mesh.has(test_meshes::kUnusable)) continue;
            const Field field = compute(mesh.mesh);
            ASSERT_EQ(field.curvature_derivatives.size(), mesh.mesh.positions.size());
            for (const Eigen::Vector4f& c : field.curvature_derivatives)
                ASSERT_TRUE(c.allFinite()) << mesh;
            ASSERT_EQ(field.smooth_curvatures.size(), mesh.mesh.positions.size());
            for (const Eigen::Vector3f& s : field.smooth_curvatures)
                ASSERT_TRUE(s.allFinite()) << mesh;
        }
}

TEST(CurvatureDerivatives, AreRefusedToAFieldOfAnotherMesh) {
    Field field = precompute(test_meshes::mesh_named("torus").mesh);
    EXPECT_THROW(add_curvature_derivatives(test_meshes::mesh_named("plane").mesh, field), Error);
    EXPECT_TRUE(field.curvature_derivatives.empty());
}

TEST(CurvatureDerivatives, CanBeCancelled) {
    const TriangleMesh& mesh = test_meshes::mesh_named("torus").mesh;
    Field field = precompute(mesh);
    EXPECT_THROW(add_curvature_derivatives(mesh, field, [](double, const char*) { return false; }),
                 Error);
    EXPECT_TRUE(field.curvature_derivatives.empty());
}

}  // namespace
