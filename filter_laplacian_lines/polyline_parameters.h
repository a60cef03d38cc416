// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "laplacian_lines/line_style.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/drawn_style.h"
#include "meshlab_host/meshlab_api.h"

/// Scripts hold the numbers: new ones come last. From Front on they are sides.
enum class ViewChoice {
    CurrentView,
    Perspective,
    Orthographic,
    Front,
    Back,
    Left,
    Right,
    Top,
    Bottom
};

/// Points and directions are in world coordinates.
struct PolylineParameters {
    ViewChoice view = ViewChoice::Front;
    Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
    Eigen::Vector3d view_direction = Eigen::Vector3d::UnitZ();  ///< towards the viewer
    int settings = 0;                                           ///< see settings_names()
    bool visible_only = true;
    laplacian_lines::LineStyle style;
    std::optional<double> light_azimuth;  ///< as DrawnStyle's; only the decoration has one
    meshlab_host::KindColors colors = meshlab_host::usual_kind_colors();
};

/// The window's current view, if any; else from the front, with a viewpoint on the side of +z that
/// sees all of the mesh.
PolylineParameters polyline_defaults(const MeshModel* mesh,
                                     const std::optional<meshlab_host::CurrentView>& window);

void list_polyline_parameters(const PolylineParameters& defaults, RichParameterList& list);

/// Applies the decoration's settings if asked for. @throws laplacian_lines::Error(InvalidOption)
/// that names a parameter out of range, or if the decoration has drawn nothing
PolylineParameters read_polyline_parameters(const RichParameterList& list);
