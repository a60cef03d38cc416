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

/// The view with the marked border, to which menus apply; empty in programs without GL views.
/// MeshLab hands filters no view, but GL views answer Qt signals that ask for their camera. GUI
/// thread only.
std::optional<CurrentView> current_view();

}  // namespace meshlab_host
