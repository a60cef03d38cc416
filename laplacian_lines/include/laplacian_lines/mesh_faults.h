// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Why the drawing of a mesh is likely to disappoint, which the user can do something about.
enum class MeshFault {
    Torn,         ///< so many borders that it is hardly a surface: pieces that do not hang together
    Disagreeing,  ///< neighbours disagree about which side is outside
    InsideOut,    ///< a closed surface whose triangles face inwards
    CoarseKernel  ///< most of the surface bends within the kernel, which could be smaller
};

/// Those that a report of precompute() tells of, in the order in which to mend them. Scans with
/// holes, and open surfaces that are finely meshed, have none.
std::vector<MeshFault> faults_of(const MeshReport& report);

}  // namespace laplacian_lines
