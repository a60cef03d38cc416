// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "drawn_view.h"
#include "line_drawing/sheet.h"

namespace line_drawing {

/// Where a view is on its sheet.
struct Placement {
    double scale;            ///< millimetres of the sheet in one of the object
    Eigen::Vector2d middle;  ///< of the view, in the sheet's coordinates

    Eigen::Vector2d onSheet(const Eigen::Vector2d& p) const {
        return {middle.x() + scale * p.x(), middle.y() - scale * p.y()};
    }
};

/// A line as it is drawn on its sheet; none if it is too short or too thin.
std::optional<SheetPath> drawStroke(const DrawnLine& line, const Placement& placement,
                                    const SheetOptions& options);

}  // namespace line_drawing
