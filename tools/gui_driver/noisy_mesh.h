// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace driver {

struct Command;

// write-noisy SHARE SEED FILE: the current layer as a PLY file, with each vertex moved by SHARE of
// the mean edge in a random direction, the same ones for the same SEED.
void writeNoisy(const Command& command);

}  // namespace driver
