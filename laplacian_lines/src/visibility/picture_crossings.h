// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "visibility/sight_segments.h"

namespace laplacian_lines {

/// Where two segments cross each other in the picture.
struct PictureCrossing {
    std::uint32_t segments[2];
    double shares[2];  ///< of the length of each, in the picture
};

/// All crossings of segments of which one divides; lines on the surface are crossed only by what is
/// before them, and segments that have surface on both sides only by each other in space. Whether
/// segments cross is decided by the turns of their four ends, each of which is found alike wherever
/// it is asked for: so a chain of segments that passes over another one crosses it once, also at a
/// vertex. In an order that does not depend on the number of threads.
std::vector<PictureCrossing> find_crossings(const SightSegments& all, const StageProgress& stage);

}  // namespace laplacian_lines
