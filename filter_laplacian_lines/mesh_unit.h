// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Units of meshes, by the number in scripts.
struct MeshUnit {
    const char* name;
    double mm;
};
inline constexpr MeshUnit mesh_units[] = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}};

/// The number of the unit that a mesh of this size most likely has. Scanners measure in mm what is
/// larger than a bead, photogrammetry and phones in m what is smaller than a house; there is no
/// telling cm and inches.
constexpr int likelyUnit(double diagonal) {
    constexpr int millimetre = 0, metre = 2;
    return diagonal < 10 ? metre : millimetre;
}
