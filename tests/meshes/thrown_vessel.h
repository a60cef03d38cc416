// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

struct VesselShape {
    int rings = 600, columns = 720;
    double relief = 1;  ///< height of grooves, wave and traces of throwing; 0: smooth
    double wobble = 0;  ///< how far it is from round, mm
};

/// The profile of a jar from the middle of its base's underside around the wall to the middle of
/// its inside: (radius, height), mm. Neighbouring points are equally far apart.
std::vector<Eigen::Vector2d> vessel_profile(int points);

/// A jar thrown on the wheel, of 200 mm, with the y axis as its axis: a closed surface of a wall of
/// 4 to 8 mm, two grooves and an incised wave on its shoulder, traces of throwing inside.
laplacian_lines::TriangleMesh thrown_vessel(const VesselShape& shape = {});

}  // namespace test_meshes
