// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace line_renderer {

/// Depths 0..1 of a viewport: the window's pixel (x, y) is at (x, y) · texel.
struct DepthTexture {
    unsigned id = 0;  ///< OpenGL's name, of the current share group; 0: there is none
    Eigen::Vector2f texel = Eigen::Vector2f::Zero();
    bool is_complete = false;  ///< holds all that is in the depth buffer too
};

}  // namespace line_renderer
