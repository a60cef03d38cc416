// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/sheet.h"
#include "pixels/canvas.h"

namespace line_drawing {

/// The upper left `size` pixels of a sheet. @throws std::bad_alloc
Canvas paint_groups(const std::vector<SheetGroup>& groups, const Eigen::Vector2i& size,
                    double pixels_per_mm);

}  // namespace line_drawing
