// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A property of the widget of a view, a number: lines are drawn so many times as wide as the
/// parameters say. For pictures that are larger than a view usually is in a window.
constexpr const char* line_scale_property = "laplacian_lines_scale";
