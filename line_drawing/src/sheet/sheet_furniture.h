// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sheet/sheet_layout.h"

namespace line_drawing {

/// What frames the drawing: names of the views, scale bar, projection symbol, title.
SheetGroup drawFurniture(const std::vector<DrawnView>& views, const SheetLayout& layout,
                         const Eigen::Vector3d& object_size, const SheetOptions& options);

/// The longest usual length, 1, 2 or 5 times a power of ten, of which the drawing is at most `most`
/// long; in the object's mm.
double barLength(double scale, double most);
/// "50.0 × 20.0 × 1.00 mm"
std::string sizeInWords(const Eigen::Vector3d& size);
/// The text if it fits the width, as far as that can be told without a font; else its beginning
/// and "…".
std::string elided(const std::string& text, double height, double width);
/// "5 cm" of 50.
std::string lengthInWords(double mm);

}  // namespace line_drawing
