// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/snapshot_tiles.h"

#include <cmath>

namespace meshlab_host {
namespace {

/// How far the frustum's middle is left of and below the axis of sight, in half widths and heights.
/// Tile c of n has n - 1 - 2c, an integer.
Eigen::Vector2d offset(const Eigen::Matrix4d& projection) {
    // Perspective divides by -z, hence the sign.
    return isOrthographic(projection) ? Eigen::Vector2d(projection.col(3).head<2>())
                                      : Eigen::Vector2d(-projection.col(2).head<2>());
}

void moveToMiddle(Eigen::Matrix4d& projection) {
    projection.col(isOrthographic(projection) ? 3 : 2).head<2>().setZero();
}

bool isWhole(double number) {
    return std::abs(number - std::round(number)) < 1e-3;
}

/// Tiles start at the lower left.
bool isFirstTile(const Eigen::Vector2d& offset) {
    return offset.x() > 0.5 && std::abs(offset.x() - offset.y()) < 1e-3 && isWhole(offset.x());
}

}  // namespace

double SnapshotTiles::scale(const CameraMatrices& camera) {
    // Asked first: an inner tile can look like the first one of fewer.
    const bool is_next = scale_ > 1 && camera.modelview.isApprox(camera_.modelview, 1e-6) &&
                         std::abs(camera.projection(1, 1) / camera_.projection(1, 1) - 1) < 1e-5;
    if (is_next) return scale_;
    const Eigen::Vector2d place = offset(camera.projection);
    if (!isFirstTile(place)) return 1;
    camera_ = middle_ = camera;
    moveToMiddle(middle_.projection);
    scale_ = 1 + std::round(place.x());
    return scale_;
}

}  // namespace meshlab_host
