// SPDX-License-Identifier: GPL-3.0-or-later
// The field moves and scales with the mesh, wherever it is and however its vertices are numbered.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using helpers::relative_error;

const TriangleMesh& base() {
    return test_meshes::mesh_named("bumpy_sphere").mesh;
}

TriangleMesh transformed(const Eigen::Affine3d& transform) {
    return test_meshes::mapped(base(), [&](Eigen::Vector3d& p) { p = transform * p; });
}

std::vector<Eigen::Vector3d> applied(const Eigen::Matrix3d& a,
                                     const std::vector<Eigen::Vector3f>& vectors) {
    std::vector<Eigen::Vector3d> result;
    for (const Eigen::Vector3f& v : vectors)
        result.push_back(a * v.cast<double>());
    return result;
}

/// `scale` multiplies lengths; `tolerance` allows for rounded coordinates.
void expect_equivariant(const Eigen::Matrix3d& rotation, double scale,
                        const Eigen::Vector3d& offset, double tolerance) {
    const Eigen::Affine3d transform =
        Eigen::Translation3d(offset) * Eigen::Affine3d(scale * rotation);
    PrecomputeOptions options;
    options.kernel_size = 0.1;
    const Field field = precompute(base(), options);
    options.kernel_size *= scale;
    const Field moved = precompute(transformed(transform), options);
    EXPECT_LT(relative_error(moved.normals, applied(rotation, field.normals)), tolerance);
    EXPECT_LT(relative_error(moved.laplacian_normals,
                             applied(rotation / (scale * scale), field.laplacian_normals)),
              tolerance);
    double error = 0, size = 0;
    for (std::size_t v = 0; v < field.normals.size(); ++v) {
        const Eigen::Matrix3d expected =
            rotation * helpers::matrix(field.shape_operators[v]) * rotation.transpose() / scale;
        error += (helpers::matrix(moved.shape_operators[v]) - expected).squaredNorm();
        size += expected.squaredNorm();
    }
    EXPECT_LT(std::sqrt(error / size), tolerance);
    EXPECT_NEAR(moved.scale.kernel_size, scale * field.scale.kernel_size,
                1e-6 * moved.scale.kernel_size);
}

const Eigen::Matrix3d kTurn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();

TEST(Invariance, Rotation) {
    // A turned mesh has another diagonal; √h is given, so only sources at the cutoff differ.
    expect_equivariant(kTurn, 1, Eigen::Vector3d::Zero(), 3e-5);
}

TEST(Invariance, Offset) {
    expect_equivariant(Eigen::Matrix3d::Identity(), 1, {1e4, -2e4, 3e4}, 1e-5);
}

TEST(Invariance, ScaleFromMicrometresToKilometres) {
    for (double scale : {1e-6, 1e-3, 1e3, 1e6})
        expect_equivariant(Eigen::Matrix3d::Identity(), scale, Eigen::Vector3d::Zero(), 3e-6);
}

TEST(Invariance, NumberingOfVerticesAndTriangles) {
    TriangleMesh shuffled = base();
    std::vector<std::uint32_t> order(base().positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::mt19937 random(3);
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random() % i]);
    for (std::size_t v = 0; v < order.size(); ++v)
        shuffled.positions[order[v]] = base().positions[v];
    for (Triangle& t : shuffled.triangles)
        t = {order[t[1]], order[t[2]], order[t[0]]};
    std::reverse(shuffled.triangles.begin(), shuffled.triangles.end());
    const Field field = precompute(base()), other = precompute(shuffled);
    for (std::size_t v = 0; v < order.size(); ++v) {
        EXPECT_LT((field.laplacian_normals[v] - other.laplacian_normals[order[v]]).norm(), 1e-4);
        EXPECT_LT((field.normals[v] - other.normals[order[v]]).norm(), 1e-6);
    }
}

/// The share of `lines` within a distance of `others`.
double share_near(const LineSet& lines, const LineSet& others, double distance) {
    double near = 0, all = 0;
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
            const Eigen::Vector3d a = lines.points[i - 1].position.cast<double>(),
                                  b = lines.points[i].position.cast<double>();
            all += (b - a).norm();
            if (helpers::distance_to_lines(b, others) < distance) near += (b - a).norm();
        }
    return all > 0 ? near / all : 1;
}

LineSet brought_back(LineSet lines, const Eigen::Affine3d& transform) {
    for (LinePoint& p : lines.points)
        p.position = (transform.inverse() * lines.position(p)).cast<float>();
    lines.origin.setZero();
    return lines;
}

/// Frames of C, clusters and sums differ.
void expect_moved_lines(const Eigen::Matrix3d& turn, double scale, const Eigen::Vector3d& offset) {
    const Eigen::Affine3d transform = Eigen::Translation3d(offset) * Eigen::Affine3d(scale * turn);
    const TriangleMesh mesh = transformed(transform);
    const LineExtractor here(base(), helpers::complete_field(base())),
        there(mesh, helpers::complete_field(mesh));
    const double near = 1e-3;
    const Eigen::Vector3d eye(3, 1, 2);
    for (const LineKindDescription& row : kLineKinds)
        for (const double w : {0., 1.}) {
            LineStyle style = helpers::only(row.kind);
            style.detail = 80;
            const LineSet a = helpers::extract(here, {eye, w}, style);
            const Eigen::Vector3d moved = w > 0 ? transform * eye : turn * eye;
            const LineSet b = brought_back(helpers::extract(there, {moved, w}, style), transform);
            EXPECT_GT(share_near(a, b, near), 0.99) << row.key << ", w " << w;
            EXPECT_GT(share_near(b, a, near), 0.99) << row.key << ", w " << w;
            const bool is_absent =  // of what is smooth and closed
                helpers::lies_on_the_surface(row.kind) && row.kind != LineKind::DemarcatingCurve;
            EXPECT_EQ(a.lines.empty(), is_absent) << row.key << ", w " << w;
            EXPECT_EQ(b.lines.empty(), is_absent) << row.key << ", w " << w;
        }
}

/// A turn of axes into axes keeps the box's diagonal, on which thresholds depend.
TEST(Invariance, LinesOfAllKindsMoveAndScaleWithTheMesh) {
    Eigen::Matrix3d turn;
    turn << 0, -1, 0, 0, 0, -1, 1, 0, 0;
    expect_moved_lines(turn, 50, {200, -100, 300});
    expect_moved_lines(Eigen::Matrix3d::Identity(), 1e-6, {0, 0, 0});
    expect_moved_lines(Eigen::Matrix3d::Identity(), 1, {1e4, -2e4, 1e4});
}

}  // namespace
