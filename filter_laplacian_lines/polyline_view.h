// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <QString>
#include <optional>

#include "laplacian_lines/view.h"
#include "line_drawing/view_frame.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/filter.h"
#include "polyline_parameters.h"

// The camera of the polyline filter, in world coordinates.

/// A viewpoint that was chosen looks at `centre` of the mesh. @throws
/// laplacian_lines::Error(InvalidOption) if there is no window's view to take
line_drawing::ViewFrame frame_of(const PolylineParameters& chosen, const Eigen::Vector3d& centre,
                                 const std::optional<meshlab_host::CurrentView>& window);

/// For the log: "orthographic, along the view direction 0 0 1 (Front)".
QString view_text(const line_drawing::ViewFrame& frame, const PolylineParameters& chosen);

/// In mesh coordinates, with the light. @throws laplacian_lines::Error(InvalidOption) if the
/// layer's transformation is singular
laplacian_lines::View view_of(const line_drawing::ViewFrame& frame,
                              const PolylineParameters& chosen, const Eigen::Matrix4d& layer);

/// A warning if the eye does not see all of a box in world coordinates; empty without an eye.
QString nearness_warning(const line_drawing::ViewFrame& frame, const Eigen::AlignedBox3d& box);

/// Adds the camera, with which lines can be projected to a picture, in world coordinates:
/// "viewpoint" of perspective views, "view_direction" to the viewer, "up".
void add_results(const line_drawing::ViewFrame& frame, meshlab_host::FilterResults& results);
