// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

namespace meshlab_host {

/// In world coordinates.
struct CurrentView {
    bool is_orthographic;
    Eigen::Vector3d eye;
    Eigen::Vector3d towards_viewer;  ///< unit, from what the camera looks at
    Eigen::Vector3d up;              ///< unit, of the picture
};

/// The view with the marked border, to which menus apply; empty if there is none. MeshLab hands
/// filters no view, but GL views have a slot that sends their camera as a signal. GUI thread only.
std::optional<CurrentView> current_view();

}  // namespace meshlab_host
