// SPDX-License-Identifier: GPL-3.0-or-later
// How large a picture is whose tiles are drawn one after the other.
#include <gtest/gtest.h>

#include "meshlab_host/camera.h"

namespace {

using meshlab_host::CameraMatrices;
using meshlab_host::SnapshotTiles;

/// A tile of n by n, counted from the lower left: its part of a frustum from -1 to 1.
CameraMatrices tile_of(int n, int column, int row, bool is_orthographic) {
    const double near = 2, far = 9, size = 1.0 / n;
    const double x = (2 * column + 1 - n) * size, y = (2 * row + 1 - n) * size;  // the middle
    CameraMatrices camera;
    camera.modelview(2, 3) = -5;
    camera.projection.setZero();
    if (is_orthographic) {
        camera.projection.diagonal() << 1 / size, 1 / size, -2 / (far - near), 1;
        camera.projection.col(3).head<3>() << -x / size, -y / size, -(far + near) / (far - near);
        return camera;
    }
    camera.projection.diagonal() << near / size, near / size, -(far + near) / (far - near), 0;
    camera.projection.col(2).head<2>() << x / size, y / size;
    camera.projection(2, 3) = -2 * far * near / (far - near);
    camera.projection(3, 2) = -1;
    return camera;
}

class SnapshotTilesTest : public testing::TestWithParam<bool> {
protected:
    CameraMatrices tile(int n, int column, int row) const {
        return tile_of(n, column, row, GetParam());
    }

    /// A whole snapshot, row by row.
    void expect_scale_of_snapshot(int n) {
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column) {
                EXPECT_EQ(tiles_.scale(tile(n, column, row)), n)
                    << "tile " << column << ", " << row << " of " << n;
                expect_camera_of_picture(n);
            }
    }

    /// That of a view in the middle which is as large as a tile, the same for all of them.
    void expect_camera_of_picture(int n) {
        const Eigen::Matrix4d middle = tiles_.camera().projection;
        EXPECT_TRUE(middle.isApprox(tile(1, 0, 0).projection.cwiseProduct(scaled(n)), 1e-12))
            << middle;
        EXPECT_EQ(tiles_.camera().modelview, tile(n, 0, 0).modelview);
    }

    /// By how much the parts of a tile's projection are larger than those of the view.
    static Eigen::Matrix4d scaled(int n) {
        Eigen::Matrix4d factors = Eigen::Matrix4d::Ones();
        factors.topRows<2>() *= n;
        return factors;
    }

    SnapshotTiles tiles_;
};

TEST_P(SnapshotTilesTest, AreAsManyAsTheSnapshotHas) {
    for (int n : {2, 3, 4, 7})
        expect_scale_of_snapshot(n);
    expect_scale_of_snapshot(2);
}

TEST_P(SnapshotTilesTest, AreOneInAView) {
    EXPECT_EQ(tiles_.scale(tile(1, 0, 0)), 1);
    expect_scale_of_snapshot(4);
    EXPECT_EQ(tiles_.scale(tile(1, 0, 0)), 1) << "the view after a snapshot";
}

/// A layer that is drawn after others of the same tile, or with a part of the tiles left out.
TEST_P(SnapshotTilesTest, AreKnownHoweverOftenTheyAreAskedFor) {
    for (int time = 0; time < 3; ++time)
        EXPECT_EQ(tiles_.scale(tile(4, 0, 0)), 4);
    EXPECT_EQ(tiles_.scale(tile(4, 2, 3)), 4);
}

TEST_P(SnapshotTilesTest, AreNotThoseOfAnotherCamera) {
    EXPECT_EQ(tiles_.scale(tile(4, 0, 0)), 4);
    CameraMatrices turned = tile(4, 2, 1);
    turned.modelview(0, 3) = 0.5;
    EXPECT_EQ(tiles_.scale(turned), 1);
    CameraMatrices wider = tile(4, 0, 0);  // offsets are in half widths
    wider.projection(0, 0) /= 2;
    EXPECT_EQ(tiles_.scale(wider), 4);
    EXPECT_EQ(tiles_.camera().projection(0, 0), wider.projection(0, 0));
}

INSTANTIATE_TEST_SUITE_P(Cameras, SnapshotTilesTest, testing::Bool(), [](const auto& test) {
    return test.param ? "orthographic" : "perspective";
});

}  // namespace
