// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// A triangle narrower than 1e-4 D, and than a hundredth of its length, that is folded flat over
/// its longest side turns its back for no form. Has it and its neighbour there share their other
/// diagonal. Positions are in D.
void unfold_needles(const std::vector<Eigen::Vector3d>& positions,
                    std::vector<Triangle>& triangles);

}  // namespace laplacian_lines
