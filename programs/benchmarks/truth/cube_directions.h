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

/// By the names of directions.py: a cube's faces, edges and corners "0-0", turned "0-0 by 1e-6" or
/// "0-0 by 1 degree", or azimuth and elevation "23,31". @throws std::invalid_argument
NamedFrame direction_named(const std::string& name);

std::vector<NamedFrame> few_directions();

}  // namespace benchmarks
