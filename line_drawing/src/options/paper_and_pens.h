// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// Width and height of upright paper of a name, mm; none for "fit": as large as the drawing.
/// @throws laplacian_lines::Error(InvalidOption) that lists the names
std::optional<Eigen::Vector2d> paper_size(const std::string& name);

/// Scales of drawings, largest first: 1:2 is 0.5.
std::vector<double> usual_scales();

/// √h in widths of inner lines: smaller kernels crowd lines, larger lose detail.
constexpr double kKernelPens = 4;

/// Finer by so many steps of √2, down to .1 mm; pens above 2 mm stay.
Pens finer(Pens pens, std::ptrdiff_t steps);

/// Pens for a drawing whose largest view has this size on paper, mm: one or two steps finer if
/// small.
Pens pens_for(double size, const Pens& pens);

}  // namespace line_drawing
