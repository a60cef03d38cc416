// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_samples.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "meshlab_host/camera.h"

using laplacian_lines::Field;
using laplacian_lines::TriangleMesh;

namespace {

constexpr double height = 600;

/// Of side 2 around a place, in z = 0, facing +z.
struct Square {
    TriangleMesh mesh;
    Field field;
    explicit Square(const Eigen::Vector3d& middle = Eigen::Vector3d::Zero(), double size = 1) {
        const int n = 101;
        for (int i = 0; i < n * n; ++i) {
            const Eigen::Vector3d place(i % n * 2. / (n - 1) - 1, i / n * 2. / (n - 1) - 1, 0);
            mesh.positions.push_back(middle + size * place);
            field.normals.push_back(Eigen::Vector3f::UnitZ());
        }
    }
};

Eigen::Matrix4d perspective(double near) {  // 90 degrees upwards
    Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
    projection(0, 0) = projection(1, 1) = 1;
    projection(2, 2) = -(1000 + near) / (1000 - near);
    projection(2, 3) = -2000 * near / (1000 - near);
    projection(3, 2) = -1;
    return projection;
}

Eigen::Matrix4d orthographic() {
    Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
    projection(2, 2) = -0.01;
    return projection;
}

double pixelSize(const Square& square, const Eigen::Affine3d& to_eye,
                 const Eigen::Matrix4d& projection) {
    const auto view =
        meshlab_host::viewFromMatrices(to_eye.matrix(), projection, Eigen::Matrix4d::Identity());
    const SurfaceSamples samples(square.mesh, square.field);
    return samples.pixelSize({*view, to_eye.matrix(), projection, height});
}

Eigen::Affine3d at(double depth) {
    return Eigen::Affine3d(Eigen::Translation3d(0, 0, -depth));
}

TEST(SurfaceSamples, PixelsGrowWithTheDistance) {
    for (const double depth : {1., 3., 30.})
        EXPECT_NEAR(pixelSize(Square(), at(depth), perspective(0.01)), 2 * depth / height,
                    1e-4 * depth);
    for (const double depth : {1., 30.})  // but for parallel rays, here of a tenth of the size
        EXPECT_NEAR(pixelSize(Square(), at(depth) * Eigen::Scaling(0.1), orthographic()),
                    2 / height / 0.1, 1e-5);
}

/// Zoomed in, only what is in the picture counts.
TEST(SurfaceSamples, PixelsAreThoseOfWhatIsInThePicture) {
    const Eigen::AngleAxisd tilt(-1.2, Eigen::Vector3d::UnitX());
    for (const double zoom : {1., 10.}) {
        const Eigen::Affine3d zoomed = at(2) * Eigen::Scaling(zoom) * tilt;
        EXPECT_NEAR(pixelSize(Square(), zoomed, perspective(0.01)) * zoom, 2 * 2 / height,
                    0.3 * 2 * 2 / height)
            << zoom;
    }
}

TEST(SurfaceSamples, NothingBeforeTheEyeHasNoSize) {
    EXPECT_EQ(pixelSize(Square(), at(-3), perspective(0.01)), 0);
    EXPECT_EQ(SurfaceSamples().pixelSize({laplacian_lines::View::orthographic({0, 0, 1}),
                                          Eigen::Matrix4d::Identity(), orthographic(), height}),
              0);
}

TEST(SurfaceSamples, TheSizeIsAContinuousFunctionOfTheCamera) {
    const Square square;
    double before = 0;
    for (double angle = 0; angle < 1.5; angle += 0.005) {
        const Eigen::Affine3d to_eye =
            at(2) * Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 1, 0).normalized());
        const double size = pixelSize(square, to_eye, perspective(0.01));
        if (before > 0) {
            EXPECT_NEAR(size / before, 1, 0.02) << angle;
        }
        before = size;
    }
}

}  // namespace
