// SPDX-License-Identifier: GPL-3.0-or-later
#include "straight_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace line_renderer {
namespace {

/// Share of the tolerance for points that go backwards.
constexpr float kBackwardShare = 0.2f;
/// Pixels; nearer than this values have to stay, instead of having a slope.
constexpr float kLeastReach = 1e-3f;

float cross(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

StraightPiece::StraightPiece(float tolerance)
    : aside_((1 - kBackwardShare) * tolerance), backward_(kBackwardShare * tolerance) {}

void StraightPiece::begin(const SeenPoint& start) {
    start_ = start;
    is_empty_ = true;
    is_open_ = start.is_before_near_plane;
    reach_ = kLeastReach;
    has_cone_ = false;
    least_slope_.fill(-std::numeric_limits<float>::infinity());
    greatest_slope_.fill(std::numeric_limits<float>::infinity());
}

bool StraightPiece::try_extend(const SeenPoint& point) {
    is_open_ = is_open_ && point.is_before_near_plane;
    const Vector offset = point.pixel - start_.pixel;
    const float distance = offset.norm();
    if (!is_empty_ && !(is_open_ && can_end(point, offset, distance))) return false;
    is_empty_ = false;
    if (!is_open_) return true;
    reach_ = std::max(reach_, distance);
    narrow_directions(offset, distance);
    narrow_slopes(point);
    return true;
}

bool StraightPiece::can_end(const SeenPoint& point, const Vector& offset, float distance) const {
    if (!(distance >= reach_ - backward_)) return false;
    if (has_cone_ && !(cross(right_, offset) >= 0 && cross(offset, left_) >= 0)) return false;
    const float reach = std::max(reach_, distance);
    for (int i = 0; i < kSeenValueCount; ++i) {
        const float rise = point.values[i] - start_.values[i];
        if (!(rise >= least_slope_[i] * reach && rise <= greatest_slope_[i] * reach)) return false;
    }
    return true;
}

/// Two points at the same distance from the start are 2 sin(angle / 2) times that apart. Cones are
/// at most as wide as a half plane.
void StraightPiece::narrow_directions(const Vector& offset, float distance) {
    if (distance <= aside_ / 2) return;
    const float ratio = aside_ / distance;
    const float cosine = std::max(0.0f, 1 - ratio * ratio / 2);
    // not from the cosine, which rounds to 1 far from the start
    const float sine = cosine > 0 ? ratio * std::sqrt(1 - ratio * ratio / 4) : 1;
    const Vector left(cosine * offset.x() - sine * offset.y(),
                      cosine * offset.y() + sine * offset.x());
    const Vector right(cosine * offset.x() + sine * offset.y(),
                       cosine * offset.y() - sine * offset.x());
    if (!has_cone_ || cross(left, left_) >= 0) left_ = left;
    if (!has_cone_ || cross(right_, right) >= 0) right_ = right;
    has_cone_ = true;
}

void StraightPiece::narrow_slopes(const SeenPoint& point) {
    const float per_pixel = 1 / reach_;
    for (int i = 0; i < kSeenValueCount; ++i) {
        const float rise = point.values[i] - start_.values[i];
        const float tolerance = point.tolerance[i];
        least_slope_[i] = std::max(least_slope_[i], (rise - tolerance) * per_pixel);
        greatest_slope_[i] = std::min(greatest_slope_[i], (rise + tolerance) * per_pixel);
    }
}

}  // namespace line_renderer
