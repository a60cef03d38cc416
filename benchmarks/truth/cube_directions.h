// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "plane_lines.h"

namespace benchmarks {

struct NamedFrame {
    std::string name;
    PlaneFrame frame;
};

/// The directions of directions.py: of a cube's faces, edges and corners, exactly, and turned aside
/// by 1e-6 rad and by a degree, and four generic ones: 82.
std::vector<NamedFrame> all_directions();

/// A dozen of them, of each sort.
std::vector<NamedFrame> few_directions();

}  // namespace benchmarks
