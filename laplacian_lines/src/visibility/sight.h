// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "laplacian_lines/view.h"
#include "visibility/ray_caster.h"

namespace laplacian_lines {

/// What rays towards the eye and across contours tell. For one thread.
class Sight {
public:
    Sight(const RayCaster& caster, const View& view) : caster_(caster), view_(view) {}

    /// Towards the eye, unit; zero at the eye.
    Eigen::Vector3d towards_eye(const Eigen::Vector3d& point) const {
        return (view_.eye - view_.w * point).stableNormalized();
    }

    /// Whether nothing is between a point and the eye, but for what is nearer to the point than the
    /// clearance. Points beside each other in space may share a number, 0 to 3, to save time.
    bool is_clear(const Eigen::Vector3d& point, double clearance, int number);

    /// Whether the surface is met within `reach` before or behind a point, as the eye sees it.
    bool is_near_surface(const Eigen::Vector3d& point, double reach);

    /// Whether the surface is met from a point on in a unit direction.
    bool meets_surface(const Eigen::Vector3d& point, const Eigen::Vector3d& direction);

    /// Of the triangle nearest to a point along a unit direction, within `reach` to both sides, how
    /// much it faces that way: the cosine. 0 if there is none.
    double facing(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                  double reach) const;

private:
    const RayCaster& caster_;
    const View& view_;
    std::array<RayCaster::Hint, 4> hints_;
    RayCaster::Hint near_hint_, beyond_hint_;
};

}  // namespace laplacian_lines
