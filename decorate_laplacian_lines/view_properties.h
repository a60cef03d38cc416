// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Properties that the GUI driver gives the widget of a view before it takes pictures.

/// Factor of the widths of lines, for large pictures.
constexpr const char* line_scale_property = "laplacian_lines_scale";
/// Whether redraws wait for drawings that are otherwise computed in the background.
constexpr const char* waits_property = "laplacian_lines_waits";
