// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// What users should know of a mesh, because its drawing is likely to disappoint or is not of the
/// mesh as it is, and can mend.
enum class MeshFault {
    Torn,         ///< so many borders that it is hardly a surface: pieces that do not hang together
    Disagreeing,  ///< neighbours disagree about which side is outside, and cannot agree
    InsideOut,    ///< nearly all triangles faced inwards and were turned
    Turned,       ///< some did, or disagreed with their neighbours
    Quantized,    ///< coordinates were rounded so much that smooth parts look like facets
    CoarseKernel  ///< most of the surface bends within the kernel, which could be smaller
};

/// In the order in which to mend them. Scans with holes and finely meshed open surfaces have none.
std::vector<MeshFault> faults_of(const MeshReport& report);

/// A sentence or two, with what mends it.
std::string describe(MeshFault fault, const MeshReport& report);

}  // namespace laplacian_lines
