// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"
#include "rules/line_rules.h"

namespace reference {

/// Weights, opacities and smoothed positions of a traced line, point by point and pass by pass. On
/// entry weights hold the sums of the slopes of a point's segments, opacities the fading of its
/// crossing, and positions are local; then they are mesh coordinates.
void finish_plainly(const laplacian_lines::LineRules& rules, const laplacian_lines::Polyline& line,
                    const Eigen::Vector3d& centre, double diagonal,
                    laplacian_lines::LinePoint* points);

}  // namespace reference
