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

/// The numbers are what scripts hold: new ones come last. From Front on they are sides.
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

/// An orthographic view along an axis of the world, as in MeshLab's menu; of the choices from Front
/// on.
line_drawing::ViewFrame sideView(ViewChoice choice);

/// What the user chose for lines as polylines. Points and directions are in world coordinates.
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

/// Where the dialog starts: at the current view of the window if there is one, otherwise in front
/// of the mesh, with a viewpoint on the side of +z from which all of it is seen.
PolylineParameters polylineDefaults(const MeshModel* mesh,
                                    const std::optional<meshlab_host::CurrentView>& window);

void listPolylineParameters(const PolylineParameters& defaults, RichParameterList& list);

/// The parameters that are numbers, switches or choices; places are not among them.
std::vector<meshlab_host::ParameterDescription> describePolylineParameters();

/// Which choice of another parameter a point or a direction needs to have an effect.
struct PlaceUse {
    QString place;
    QString parameter;
    int choice;
};
std::vector<PlaceUse> polylinePlaces();

/// With the decoration's settings put into effect, if they are asked for.
/// @throws laplacian_lines::Error(InvalidOption) that names a parameter which is out of range, or
/// if the decoration has drawn nothing.
PolylineParameters readPolylineParameters(const RichParameterList& list);
