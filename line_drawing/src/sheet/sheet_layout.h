// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "strokes/strokes.h"

namespace line_drawing {

/// Lengths on a sheet, mm.
constexpr double sheet_margin = 10, view_gap = 10, view_name_height = 3, strip_height = 16;

struct SheetLayout {
    Eigen::Vector2d size;
    double scale;                             ///< 0: all views are in perspective
    std::vector<Placement> placements;        ///< one for each view
    std::vector<Eigen::AlignedBox2d> places;  ///< of the views' surfaces, mm
};

/// Whether there is no scale at all.
bool areInPerspective(const std::vector<DrawnView>& views);

/// Places views in rows and columns around the front view, so that what is at one height of the
/// object is at one height of the sheet; views of other directions stand in rows below.
/// @throws laplacian_lines::Error(InvalidOption) if there is no such paper or the views do not fit.
SheetLayout layOut(const std::vector<DrawnView>& views, const SheetOptions& options);

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
