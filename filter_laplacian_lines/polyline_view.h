// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <QString>
#include <optional>

#include "laplacian_lines/view.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/filter.h"
#include "polyline_parameters.h"

/// From where the lines are seen, in world coordinates.
struct Eye {
    Eigen::Vector4d place;  ///< homogeneous: a position, or the direction to an orthographic viewer
    Eigen::Vector3d towards_viewer;  ///< unit; normal of the picture
    Eigen::Vector3d up;              ///< unit, in the picture
    QString words;                   ///< for the log
};

/// The eye that was chosen; `centre` of the mesh, where perspective ones look at.
/// @throws laplacian_lines::Error(InvalidOption) if a window's view is asked for where none is.
Eye eyeOf(const PolylineParameters& chosen, const Eigen::Vector3d& centre,
          const std::optional<meshlab_host::CurrentView>& window);

/// The same in the coordinates of a mesh, with the light.
/// @throws laplacian_lines::Error(InvalidOption) for layers whose transformation is singular.
laplacian_lines::View viewOf(const Eye& eye, const PolylineParameters& chosen,
                             const Eigen::Matrix4d& layer);

/// What to tell the user of an eye that does not see all of a box in world coordinates, because it
/// is within it or close to it. Empty if it does.
QString nearnessWarning(const Eye& eye, const Eigen::AlignedBox3d& box);

/// Adds to a filter's results what makes a flat picture of its lines: "viewpoint" of perspective
/// views, "view_direction" to the viewer, "up", as points in world coordinates.
void addResults(const Eye& eye, meshlab_host::FilterResults& results);
