// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace test_meshes {

/// Of the machined part.
namespace part {

constexpr double kLength = 1, kDepth = 0.6, kHeight = 0.4;  ///< half edges of the block
constexpr double kSlotLeft = -0.55, kSlotRight = -0.25, kSlotBottom = 0.1;  ///< x, x, z
constexpr double kStepLeft = 0.4, kStepTop = 0;                             ///< x, z
constexpr double kHoleX = 0.7, kHoleRadius = 0.2;                           ///< y = 0

/// Its outline seen along −y, (x, z), the solid to the left.
inline std::vector<Eigen::Vector2d> profile() {
    return {{-kLength, -kHeight},      {kLength, -kHeight},      {kLength, kStepTop},
            {kStepLeft, kStepTop},     {kStepLeft, kHeight},     {kSlotRight, kHeight},
            {kSlotRight, kSlotBottom}, {kSlotLeft, kSlotBottom}, {kSlotLeft, kHeight},
            {-kLength, kHeight}};
}

}  // namespace part
}  // namespace test_meshes
