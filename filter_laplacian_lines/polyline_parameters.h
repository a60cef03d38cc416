// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "laplacian_lines/line_style.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/meshlab_api.h"

enum class ViewChoice { CurrentView, Perspective, Orthographic };
enum class LightChoice { AtTheEye, FromADirection };

/// What the user chose for lines as polylines. Points and directions are in world coordinates.
struct PolylineParameters {
    ViewChoice view = ViewChoice::Perspective;
    Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
    Eigen::Vector3d view_direction = Eigen::Vector3d::UnitZ();  ///< towards the viewer
    bool visible_only = true;
    LightChoice light = LightChoice::AtTheEye;
    Eigen::Vector3d light_direction = Eigen::Vector3d::UnitZ();  ///< towards the light
    laplacian_lines::LineStyle style;
};

/// Where the dialog starts: at the current view of the window if there is one, otherwise before the
/// mesh, on the side of +z.
PolylineParameters polylineDefaults(const MeshModel* mesh,
                                    const std::optional<meshlab_host::CurrentView>& window);

void listPolylineParameters(const PolylineParameters& defaults, RichParameterList& list);

/// @throws laplacian_lines::Error(InvalidOption) that names a parameter which is out of range.
PolylineParameters readPolylineParameters(const RichParameterList& list);
