// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Properties of the widget of a view, for pictures. A number: lines are drawn so many times as
/// wide as the parameters say, where the picture is larger than a view usually is in a window.
constexpr const char* line_scale_property = "laplacian_lines_scale";
/// If true, redraws wait for what they otherwise have computed in the background.
constexpr const char* waits_property = "laplacian_lines_waits";
