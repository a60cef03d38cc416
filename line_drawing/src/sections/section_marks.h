// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "line_drawing/sheet.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// Mesh coordinates; `box` is the mesh's bounding box.
inline double position_on_axis(const Section& section, const Eigen::AlignedBox3d& box) {
    return box.min()[section.axis] + section.share * box.sizes()[section.axis];
}

/// Marks of the sections that are seen edge-on. `box` is the mesh's bounding box.
std::vector<SectionMark> marks_of(const ViewFrame& frame, const SheetOptions& options,
                                  const Eigen::AlignedBox3d& box);

/// The space for marks to either side of the surface, and as much above as below, mm on the sheet.
Eigen::Vector2d room_of_marks(const DrawnView& view);

/// Draws the ends of each cutting plane's line, with an arrow in the viewing direction and a letter
/// (ISO 128-3).
SheetLayer draw_marks(const DrawnView& view, const Placement& placement,
                      const SheetOptions& options);

}  // namespace line_drawing
