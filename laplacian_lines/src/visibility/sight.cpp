// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/sight.h"

#include <cmath>
#include <limits>

namespace laplacian_lines {

bool Sight::is_clear(const Eigen::Vector3d& point, double clearance, int number) {
    const Eigen::Vector3d to_eye = view_.eye - view_.w * point;
    if (!(to_eye.norm() > 0)) return true;
    const Eigen::Vector3d direction = to_eye.normalized();
    const double length = view_.w == 0 ? std::numeric_limits<double>::infinity()
                                       : to_eye.norm() / std::abs(view_.w) - clearance;
    return length <= 0 || !caster_.is_hit({point + clearance * direction, direction, length},
                                          hints_[std::size_t(number)]);
}

bool Sight::is_near_surface(const Eigen::Vector3d& point, double reach) {
    const Eigen::Vector3d direction = towards_eye(point);
    return caster_.is_hit({point - reach * direction, direction, 2 * reach}, near_hint_);
}

bool Sight::meets_surface(const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
    return caster_.is_hit({point, direction, std::numeric_limits<double>::infinity()},
                          beyond_hint_);
}

double Sight::facing(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                     double reach) const {
    return caster_.normal_near_middle({point - reach * direction, direction, 2 * reach})
        .dot(direction);
}

}  // namespace laplacian_lines
