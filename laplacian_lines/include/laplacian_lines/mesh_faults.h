// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Why the drawing of a mesh is likely to disappoint, where the user can mend it.
enum class MeshFault {
    Torn,         ///< so many borders that it is hardly a surface: pieces that do not hang together
    Disagreeing,  ///< neighbours disagree about which side is outside
    InsideOut,    ///< a closed surface whose triangles face inwards
    CoarseKernel  ///< most of the surface bends within the kernel, which could be smaller
};

/// In the order in which to mend them. Scans with holes and finely meshed open surfaces have none.
std::vector<MeshFault> faults_of(const MeshReport& report);

}  // namespace laplacian_lines
