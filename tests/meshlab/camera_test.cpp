// SPDX-License-Identifier: GPL-3.0-or-later
// The light that turns with the camera: its direction in mesh coordinates.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "meshlab_host/camera.h"

namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using meshlab_host::direction_in_mesh;

constexpr double kTiny = 1e-12;

Matrix4d turned(double angle, const Vector3d& axis, const Vector3d& shift) {
    Eigen::Isometry3d result(Eigen::AngleAxisd(angle, axis.normalized()));
    result.pretranslate(shift);
    return result.matrix();
}

const Matrix4d kModelview = turned(0.7, {1, -2, 0.5}, {3, 4, -5});
const Matrix4d kRigid = turned(-1.9, {0.3, 1, 2}, {-7, 0, 1});

/// Unequal scales, a mirror and a shear.
Matrix4d distorting() {
    Matrix4d result = kRigid;
    result.topLeftCorner<3, 3>() *= Vector3d(-0.5, 2, 7).asDiagonal();
    result(0, 1) += 0.8;
    return result;
}

TEST(DirectionInMesh, TurnsBackWhatTheCameraHasTurned) {
    const Vector3d direction(0.3, -0.8, 0.4);
    const auto in_mesh = direction_in_mesh(direction, kModelview, kRigid);
    ASSERT_TRUE(in_mesh);
    const Eigen::Matrix3d turn = (kModelview * kRigid).topLeftCorner<3, 3>();
    EXPECT_TRUE((turn * *in_mesh).isApprox(direction, kTiny));
    EXPECT_NEAR(in_mesh->norm(), direction.norm(), kTiny);
}

/// Under any transformation of the layer, n·d = 0 on faces that a ray grazes in the scene.
TEST(DirectionInMesh, GrazesTheFacesThatTheLightGrazesInTheScene) {
    const Vector3d in_scene(0.2, 0.9, -0.4), other(-1, 0.5, 0.25);
    const Eigen::Matrix3d to_eye = (kModelview * distorting()).topLeftCorner<3, 3>();
    // A face along the light, by its sides in the mesh.
    const Vector3d side = to_eye.inverse() * in_scene, other_side = to_eye.inverse() * other;
    const auto light = direction_in_mesh(in_scene, kModelview, distorting());
    ASSERT_TRUE(light);
    EXPECT_NEAR(light->normalized().dot(side.cross(other_side).normalized()), 0, 1e-9);
}

/// From straight behind an orthographic viewer.
TEST(DirectionInMesh, AgreesWithTheEye) {
    Matrix4d projection = Matrix4d::Identity();
    const auto view = meshlab_host::view_from_matrices(kModelview, projection, distorting());
    const auto light = direction_in_mesh(Vector3d::UnitZ(), kModelview, distorting());
    ASSERT_TRUE(light);
    EXPECT_EQ(view.w, 0);
    EXPECT_TRUE(light->normalized().isApprox(view.eye.normalized(), 1e-9));
}

TEST(DirectionInMesh, IsEmptyWithoutAnInverse) {
    Matrix4d flat = kRigid;
    flat.col(0).setZero();
    EXPECT_FALSE(direction_in_mesh(Vector3d::UnitZ(), kModelview, flat));
}

}  // namespace
