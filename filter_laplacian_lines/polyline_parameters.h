// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "laplacian_lines/line_style.h"
#include "line_drawing/view_frame.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/drawn_style.h"
#include "meshlab_host/meshlab_api.h"
#include "meshlab_host/parameters.h"

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
/// From FirstMixture on they are laplacian_lines::line_mixtures.
enum class SettingsChoice { AsSetBelow, AsTheDecoration, FirstMixture };
enum class LightChoice { AtTheEye, FromADirection };

/// Orthographic along a world axis, as in MeshLab's menu; for choices from Front on.
line_drawing::ViewFrame sideView(ViewChoice choice);

/// Points and directions are in world coordinates.
struct PolylineParameters {
    ViewChoice view = ViewChoice::Front;
    Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();
    Eigen::Vector3d view_direction = Eigen::Vector3d::UnitZ();  ///< towards the viewer
    SettingsChoice settings = SettingsChoice::AsSetBelow;
    bool visible_only = true;
    LightChoice light = LightChoice::AtTheEye;
    Eigen::Vector3d light_direction = Eigen::Vector3d::UnitZ();  ///< towards the light
    laplacian_lines::LineStyle style;
    std::optional<meshlab_host::CameraLight> camera_light;  ///< only the decoration has one
    meshlab_host::KindColors colors = meshlab_host::usualKindColors();
};

/// The window's current view, if any; else in front of the mesh, with a viewpoint on the side of +z
/// that sees all of it.
PolylineParameters polylineDefaults(const MeshModel* mesh,
                                    const std::optional<meshlab_host::CurrentView>& window);

void listPolylineParameters(const PolylineParameters& defaults, RichParameterList& list);

/// Numbers, switches and choices, without places.
std::vector<meshlab_host::ParameterDescription> describePolylineParameters();

/// The choice of another parameter that a place needs to have an effect.
struct PlaceUse {
    QString place;
    QString parameter;
    int choice;
};
std::vector<PlaceUse> polylinePlaces();

/// Applies the decoration's settings if asked for. @throws laplacian_lines::Error(InvalidOption)
/// that names a parameter out of range, or if the decoration has drawn nothing
PolylineParameters readPolylineParameters(const RichParameterList& list);
