// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

namespace meshlab_host {

/// The camera of a GL view, in world coordinates (those of layers without a transformation).
struct CurrentView {
    bool is_orthographic;
    Eigen::Vector3d eye;
    Eigen::Vector3d towards_viewer;  ///< unit, from what the camera looks at
    Eigen::Vector3d up;              ///< unit, of the picture
};

/// What the current one of MeshLab's GL views shows: the one that has its border marked, to which
/// menus apply. Empty in programs without a GL view. MeshLab hands filters no view, but its GL
/// views answer whoever asks for their camera by Qt's signals. GUI thread only.
std::optional<CurrentView> currentView();

}  // namespace meshlab_host
