// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <QString>
#include <optional>

#include "laplacian_lines/view.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/filter.h"
#include "polyline_parameters.h"

/// In world coordinates.
struct Eye {
    Eigen::Vector4d place;  ///< homogeneous: a position, or the direction to an orthographic viewer
    Eigen::Vector3d towards_viewer;  ///< unit; normal of the picture
    Eigen::Vector3d up;              ///< unit, in the picture
    QString words;                   ///< for the log
};

/// Perspective eyes look at `centre` of the mesh. @throws laplacian_lines::Error(InvalidOption) if
/// there is no window's view to take
Eye eyeOf(const PolylineParameters& chosen, const Eigen::Vector3d& centre,
          const std::optional<meshlab_host::CurrentView>& window);

/// In mesh coordinates, with the light. @throws laplacian_lines::Error(InvalidOption) if the
/// layer's transformation is singular
laplacian_lines::View viewOf(const Eye& eye, const PolylineParameters& chosen,
                             const Eigen::Matrix4d& layer);

/// A warning if the eye, in or near a box in world coordinates, does not see all of it.
QString nearnessWarning(const Eye& eye, const Eigen::AlignedBox3d& box);

/// Adds what flattens the lines to a picture, in world coordinates: "viewpoint" of perspective
/// views, "view_direction" to the viewer, "up".
void addResults(const Eye& eye, meshlab_host::FilterResults& results);
