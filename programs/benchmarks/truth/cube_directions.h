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

/// By their names in directions.py: of a cube's faces, edges and corners "0-0", turned aside
/// "0-0 by 1e-6" and "0-0 by 1 degree", or any azimuth and elevation "23,31".
/// @throws std::invalid_argument
NamedFrame direction_named(const std::string& name);

/// A dozen, of each sort.
std::vector<NamedFrame> few_directions();

}  // namespace benchmarks
