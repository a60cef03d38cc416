// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sheet/sheet_layout.h"

namespace line_drawing {

/// Height of letters, and of the row below a view that its name takes, mm.
constexpr double kViewNameHeight = 3, kViewNameRow = 2 * kViewNameHeight;

/// A single view has no name: the title says what it is.
bool have_names(const std::vector<DrawnView>& views, const SheetOptions& options);

/// The name below a view. `sheet_has_scale`: a view in perspective is said to have none.
std::string name_of(const ViewFrame& frame, bool sheet_has_scale);

/// Width in mm of a strip with the longest scale bar, the projection symbol and a short note; 0
/// without annotations.
double least_strip_width(const std::vector<DrawnView>& views, const SheetOptions& options);

/// Draws names of views, scale bar, projection symbol, title and notes. For the notes,
/// `object_size` in mm of the object, and `kernel`, √h in mm on paper, or 0. Appends remarks on
/// long texts.
SheetGroup draw_annotations(const std::vector<DrawnView>& views, const SheetLayout& layout,
                            const Eigen::Vector3d& object_size, double kernel,
                            const SheetOptions& options, std::vector<std::string>& remarks);

constexpr double kTitleHeight = 4;  ///< of letters, mm

/// Adds a title with its lower left corner at `corner`: one wider than `width` in smaller letters,
/// in two lines, or cut, and a remark.
void add_title(const std::string& title, const Eigen::Vector2d& corner, double width,
               SheetLayer& layer, std::vector<std::string>& remarks);

/// Width of a text in the widest common font, mm: SVG is shown in the reader's.
double width_in_any_font(const std::string& text, double height);

/// The text, or its beginning and "…".
std::string elided(const std::string& text, double height, double width);

}  // namespace line_drawing
