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
    TriangleMesh mesh = base();
    for (Eigen::Vector3d& p : mesh.positions)
        p = transform * p;
    return mesh;
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
    EXPECT_FLOAT_EQ(moved.kernel_sizes[0], float(scale) * field.kernel_sizes[0]);
}

const Eigen::Matrix3d kTurn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();

TEST(Invariance, Rotation) {
    // A turned mesh has another diagonal; √h is given, so only sources at the cutoff differ.
    expect_equivariant(kTurn, 1, Eigen::Vector3d::Zero(), 3e-5);
}

TEST(Invariance, QuarterTurnKeepsTheBox) {
    Eigen::Matrix3d turn;
    turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    expect_equivariant(turn, 1, Eigen::Vector3d::Zero(), 3e-6);
}

TEST(Invariance, Offset) {
    expect_equivariant(Eigen::Matrix3d::Identity(), 1, {1e4, -2e4, 3e4}, 1e-5);
}

TEST(Invariance, ScaleFromMicrometresToKilometres) {
    for (double scale : {1e-6, 1e-3, 1e3, 1e6})
        expect_equivariant(Eigen::Matrix3d::Identity(), scale, Eigen::Vector3d::Zero(), 3e-6);
}

TEST(Invariance, ScaleAndOffsetTogether) {
    expect_equivariant(kTurn, 1e-3, {10, 0, -5}, 1e-4);
}

/// The mirrored mesh is inside out, and read the right way round.
TEST(Invariance, MirroringMirrorsTheNormals) {
    TriangleMesh mirrored = base();
    for (Eigen::Vector3d& p : mirrored.positions)
        p.x() = -p.x();
    const Field field = precompute(base()), other = precompute(mirrored);
    const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
    EXPECT_LT(relative_error(other.normals, applied(mirror, field.normals)), 1e-6);
    EXPECT_LT(relative_error(other.laplacian_normals, applied(mirror, field.laplacian_normals)),
              2e-4);  // the vertices lie otherwise in the grid of the sums
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

void expect_same_lines(double scale, const Eigen::Vector3d& offset) {
    const Eigen::Affine3d transform = Eigen::Translation3d(offset) * Eigen::Scaling(scale);
    const TriangleMesh mesh = transformed(transform);
    const LineExtractor here(base(), precompute(base())), there(mesh, precompute(mesh));
    for (const Eigen::Vector3d& eye : {Eigen::Vector3d(3, 1, 2), Eigen::Vector3d(-1, 2, 0.5)}) {
        const LineSet a = helpers::extract(here, View::perspective(eye), {});
        const LineSet b = helpers::extract(there, View::perspective(transform * eye), {});
        ASSERT_EQ(a.lines.size(), b.lines.size());
        ASSERT_EQ(a.points.size(), b.points.size());
        ASSERT_GT(a.lines.size(), 2u);
        for (std::size_t i = 0; i < a.points.size(); ++i) {
            const Eigen::Vector3d expected = transform * a.points[i].position.cast<double>();
            EXPECT_LT((b.points[i].position.cast<double>() - expected).norm(),
                      1e-4 * scale + 1e-7 * offset.norm());
            EXPECT_NEAR(a.points[i].gradient, b.points[i].gradient, 1e-3 * a.points[i].gradient);
        }
        for (std::size_t i = 0; i < a.lines.size(); ++i) {
            EXPECT_EQ(a.lines[i].closed, b.lines[i].closed);
            EXPECT_NEAR(a.lines[i].length, b.lines[i].length, 1e-4);
        }
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
        p.position = (transform.inverse() * p.position.cast<double>()).cast<float>();
    return lines;
}

/// A quarter turn keeps the box's diagonal, on which thresholds depend. Frames of C, clusters and
/// sums differ.
TEST(Invariance, LinesOfAllKindsMoveWithTheMesh) {
    Eigen::Matrix3d turn;
    turn << 0, -1, 0, 0, 0, -1, 1, 0, 0;
    const Eigen::Affine3d transform =
        Eigen::Translation3d(200, -100, 300) * Eigen::Affine3d(50 * turn);
    const TriangleMesh mesh = transformed(transform);
    const LineExtractor here(base(), helpers::complete_field(base())),
        there(mesh, helpers::complete_field(mesh));
    const Eigen::Vector3d eye(3, 1, 2);
    int with_lines = 0;
    for (const LineKindDescription& row : line_kinds)
        for (const double w : {0., 1.}) {
            LineStyle style = helpers::only(row.kind);
            style.detail = 80;
            const LineSet a = helpers::extract(here, {eye, w}, style);
            const Eigen::Vector3d moved = w > 0 ? transform * eye : turn * eye;
            const LineSet b = brought_back(helpers::extract(there, {moved, w}, style), transform);
            EXPECT_GT(share_near(a, b, 1e-3), 0.99) << row.key << ", w " << w;
            EXPECT_GT(share_near(b, a, 1e-3), 0.99) << row.key << ", w " << w;
            EXPECT_EQ(a.lines.empty(), b.lines.empty()) << row.key;
            with_lines += !a.lines.empty();
        }
    EXPECT_GE(with_lines, 12);  // not ridges, valleys and borders
}

TEST(Invariance, LinesScaleWithTheMesh) {
    // Powers of two keep every bit of the coordinates.
    expect_same_lines(std::ldexp(1.0, 20), Eigen::Vector3d::Zero());
    expect_same_lines(std::ldexp(1.0, -20), Eigen::Vector3d::Zero());
}

TEST(Invariance, LinesAreTheSameFarFromTheOrigin) {
    // To the precision of float points.
    expect_same_lines(1, {1e6, -1e6, 1e6});
    expect_same_lines(1e-8, {0, 0, 1});
    expect_same_lines(1e8, {1e6, 1e6, 0});
}

}  // namespace
