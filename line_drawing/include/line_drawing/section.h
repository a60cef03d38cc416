// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "line_drawing/view_frame.h"

namespace line_drawing {

/// A plane across an axis of the mesh.
struct Section {
    int axis = 0;        ///< 0 to 2: x, y, z
    double share = 0.5;  ///< where across the bounding box, 0 to 1
};

/// From names such as "y=0.5", separated by commas or spaces.
/// @throws laplacian_lines::Error(InvalidOption)
std::vector<Section> parseSections(std::string_view text);

/// "A", "B", ..., "Z", "AA", ...
std::string letterOf(std::size_t number);

/// Looks along the section's axis: from above, from the front or from the left.
ViewFrame frameOfSection(const Section& section, UpAxis up);

}  // namespace line_drawing
