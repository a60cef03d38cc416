// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/ridge_candidates.h"

namespace laplacian_lines {

/// Makes the gradient of each point of the candidates the angle of the edge there, in degrees, and
/// moves the points to its middle. The angle is that by which the surface turns across the line
/// within 2 % of D to both sides, in the mean along 1.5 % of the line, whatever the triangles' and
/// the kernel's size; less, down to 0, where the surface goes on turning as fast beyond, as a bump
/// does, or turns on one side only. The number of threads does not matter.
void measure_ridge_angles(const ExtractorData& data, const std::vector<PlacedCluster>& placed,
                          Crest crest, RidgeCandidates& candidates);

}  // namespace laplacian_lines
