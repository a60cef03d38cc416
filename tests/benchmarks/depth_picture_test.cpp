// SPDX-License-Identifier: GPL-3.0-or-later
// The picture that drawings are measured by, against scenes whose pixels are known.
#include "depth_picture.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "flat_scenes.h"
#include "generators.h"

namespace {

using namespace benchmarks;
using namespace flat_scenes;
using laplacian_lines::TriangleMesh;
using laplacian_lines::View;

std::size_t surface_pixels(const DepthPicture& picture) {
    std::size_t count = 0;
    for (int y = 0; y < picture.size(); ++y)
        for (int x = 0; x < picture.size(); ++x)
            count += picture.is_surface(x, y);
    return count;
}

TEST(PictureCameras, ShowAMeshInTheMiddleAndUpright) {
    const TriangleMesh mesh = square();
    const PictureCamera camera = from_above(mesh);
    EXPECT_TRUE(camera.project({-1, 1, 0}).head<2>().isApprox(Eigen::Vector2d(10, 10)));
    EXPECT_TRUE(camera.project({1, -1, 0}).head<2>().isApprox(Eigen::Vector2d(90, 90)));
    EXPECT_LT(camera.project({0, 0, 1}).z(), camera.project({0, 0, 0}).z());
}

TEST(PictureCameras, InPerspectiveShowWhatIsNearerLarger) {
    const TriangleMesh mesh = square();
    const PictureCamera camera(View::perspective({0, 0, 4}), mesh, kSize);
    EXPECT_NEAR(camera.project({1, 0, 0}).x(), 90, 1e-9);
    EXPECT_NEAR(camera.project({1, 0, 2}).x(), 50 + 2 * 40, 1e-9);
    EXPECT_NEAR(camera.project({1, 0, 2}).z(), 2, 1e-9);
}

TEST(PictureCameras, RefuseAnEyeThatHasPartsOfTheMeshBehindIt) {
    const TriangleMesh mesh = test_meshes::cube(1);
    EXPECT_THROW(PictureCamera(View::perspective({0, 0, 0.5}), mesh, kSize), std::invalid_argument);
}

TEST(ViewsAround, SeeAMeshFromAllSidesAndInBothWays) {
    const TriangleMesh mesh = test_meshes::cube(1);
    const std::vector<View> views = views_around(mesh, 12);
    ASSERT_EQ(views.size(), 12u);
    int perspective = 0;
    for (const View& view : views) {
        perspective += view.w != 0;
        const double nearest = view.w == 0 ? 0 : view.eye.norm();
        if (view.w != 0) {
            EXPECT_NEAR(nearest, 1.25 * std::sqrt(12.0), 1e-9);
        }
    }
    EXPECT_EQ(perspective, 6);
    for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1.0, 1.0}) {
            double most = -1;
            for (const View& view : views)
                most = std::max(most, side * view.eye.normalized()[axis]);
            EXPECT_GT(most, 0.8) << "axis " << axis << ", side " << side;
        }
}

TEST(DepthPictures, HoldThePixelsOfATriangle) {
    // The lower left half of the pixels 10 to 89: the diagonal passes through pixels' middles.
    TriangleMesh mesh = square();
    mesh.triangles = {{0, 1, 3}};
    const PictureCamera camera = from_above(mesh);
    const DepthPicture picture(camera, mesh);
    EXPECT_EQ(surface_pixels(picture), 80u * 81 / 2);
    EXPECT_TRUE(picture.is_surface(10, 89));
    EXPECT_TRUE(picture.is_surface(10, 10));
    EXPECT_TRUE(picture.is_surface(89, 89));
    EXPECT_FALSE(picture.is_surface(11, 10));
    EXPECT_FALSE(picture.is_surface(9, 89));
    EXPECT_FALSE(picture.is_surface(10, 90));
    EXPECT_EQ(picture.depth_at(5, 5), std::numeric_limits<double>::infinity());
}

TEST(DepthPictures, HaveNoGapsBetweenTriangles) {
    const TriangleMesh mesh = test_meshes::plane(13, 0.3);
    const PictureCamera camera = from_above(mesh);
    EXPECT_EQ(surface_pixels(DepthPicture(camera, mesh)), 80u * 80);
}

TEST(DepthPictures, ShowWhatIsNearestWhateverTheOrder) {
    for (const bool upper_first : {true, false}) {
        TriangleMesh mesh = square(upper_first ? 0.5 : 1, upper_first ? 0.25 : 0);
        test_meshes::append(mesh, square(upper_first ? 1 : 0.5, upper_first ? 0 : 0.25));
        const PictureCamera camera = from_above(mesh);
        const DepthPicture picture(camera, mesh);
        EXPECT_EQ(picture.triangle_at(50, 55) < 2, upper_first);
        EXPECT_EQ(picture.triangle_at(15, 50) < 2, !upper_first);
        EXPECT_NEAR(picture.depth_at(15, 50) - picture.depth_at(50, 55), 0.25, 1e-12);
    }
}

TEST(DepthPictures, KnowTheDepthOfASlantedPlane) {
    // z = 0.75 x, so that it is 0.75 nearer on the right.
    TriangleMesh mesh = square();
    for (Eigen::Vector3d& p : mesh.positions)
        p.z() = 0.75 * p.x();
    for (const View& view : {View::orthographic({0, 0, 1}), View::perspective({0, 0, 4})}) {
        const PictureCamera camera(view, mesh, kSize);
        const DepthPicture picture(camera, mesh);
        for (const double x : {-0.9, -0.2, 0.7}) {
            const Eigen::Vector3d p = camera.project({x, 0.1, 0.75 * x});
            EXPECT_NEAR(picture.plane_depth(0, p.x(), p.y()), p.z(), 1e-9);
            EXPECT_NEAR(picture.plane_depth(1, p.x(), p.y()), p.z(), 1e-9);
            EXPECT_NEAR(picture.depth_at(int(p.x()), int(p.y())), p.z(), 0.05);
        }
    }
}

TEST(DepthPictures, OutlineASquareByItsOuterPixels) {
    const TriangleMesh mesh = square();
    const PictureCamera camera = from_above(mesh);
    const PixelMask outline = DepthPicture(camera, mesh).outline();
    EXPECT_EQ(outline.count(), 4u * 79);
    EXPECT_TRUE(outline.has(10, 40));
    EXPECT_TRUE(outline.has(40, 89));
    EXPECT_FALSE(outline.has(11, 40));
    EXPECT_FALSE(outline.has(9, 40));
}

TEST(DepthPictures, OutlineASphereByACircle) {
    const TriangleMesh mesh = test_meshes::icosphere(5);
    const PictureCamera camera(View::orthographic({0.3, 0.5, 1}), mesh, 400);
    const PixelMask outline = DepthPicture(camera, mesh).outline();
    std::vector<bool> met(360);
    outline.for_each([&](int x, int y) {
        const Eigen::Vector2d p(x + 0.5 - 200, y + 0.5 - 200);
        EXPECT_GT(p.norm(), 158.3);
        EXPECT_LT(p.norm(), 160.3);
        met[std::size_t(std::floor((std::atan2(p.y(), p.x()) / std::acos(-1.0) + 1) * 180)) % 360] =
            true;
    });
    EXPECT_EQ(std::count(met.begin(), met.end(), true), 360);
    EXPECT_NEAR(double(outline.count()), 4 * std::sqrt(2.0) * 160, 20);
}

TEST(DepthPictures, JumpInDepthOnlyWhereOneSurfaceIsBeforeAnother) {
    TriangleMesh mesh = square();
    for (Eigen::Vector3d& p : mesh.positions)
        p.z() = 3 * p.x();  // steep, but one plane
    const std::size_t none = DepthPicture(from_above(mesh), mesh).depth_jumps(0.01).count();
    EXPECT_EQ(none, 0u);

    TriangleMesh stairs = square();
    test_meshes::append(stairs, square(0.5, 0.25));
    const PictureCamera camera = from_above(stairs);
    const DepthPicture picture(camera, stairs);
    const PixelMask jumps = picture.depth_jumps(0.2);
    EXPECT_EQ(jumps.count(), 4u * 39 + 4 * 40);  // the outer pixels of the step, and those beside
    EXPECT_TRUE(jumps.has(30, 50));
    EXPECT_TRUE(jumps.has(29, 50));
    EXPECT_FALSE(jumps.has(28, 50));
    EXPECT_EQ(picture.depth_jumps(0.3).count(), 0u);
}

TEST(DepthPictures, TellNormalsThatJumpFromDepthsThatDo) {
    // A roof whose ridge is at x = 0, in the middle of the picture.
    TriangleMesh mesh = test_meshes::plane(2);
    const double slope = std::tan(15 * std::acos(-1.0) / 180);
    for (Eigen::Vector3d& p : mesh.positions)
        p.z() = -slope * std::abs(p.x());
    test_meshes::flip_triangles(mesh, 2);  // what is meant by outside does not matter
    const PictureCamera camera = from_above(mesh);
    const DepthPicture picture(camera, mesh);
    const PixelMask jumps = picture.normal_jumps(29);
    EXPECT_EQ(jumps.count(), 2u * 80);
    EXPECT_TRUE(jumps.has(49, 33));
    EXPECT_TRUE(jumps.has(50, 33));
    EXPECT_EQ(picture.normal_jumps(31).count(), 0u);
    EXPECT_EQ(picture.depth_jumps(0.01).count(), 0u);
}

TEST(DepthPictures, AreNotDisturbedByWhatIsLeftOut) {
    TriangleMesh mesh = square();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    mesh.positions.push_back({nan, 0, 0});
    mesh.positions.push_back({50, 0, 0});
    mesh.triangles.push_back({0, 1, 4});
    mesh.triangles.push_back({0, 5, 5});
    const TriangleMesh usable = without_unusable(mesh);
    ASSERT_EQ(usable.triangles.size(), 2u);
    const PictureCamera camera = from_above(usable);
    EXPECT_EQ(surface_pixels(DepthPicture(camera, usable)), 80u * 80);
}

}  // namespace
