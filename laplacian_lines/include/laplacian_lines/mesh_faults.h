// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// Faults that spoil the drawing, or were repaired for it, and that users can repair in the mesh.
enum class MeshFault {
    Torn,         ///< so many borders that it is hardly a surface, but loose pieces
    Disagreeing,  ///< neighbours disagree about which side is outside, and cannot agree
    InsideOut,    ///< nearly all triangles faced inwards and were turned
    Flipped,      ///< some did, or disagreed with their neighbours
    Quantized     ///< coordinates were rounded so much that smooth parts look like facets
};

/// In the order of repair. Scans with holes and finely meshed open surfaces have none.
std::vector<MeshFault> faults_of(const MeshReport& report);

/// A sentence or two, with the repair.
std::string describe(MeshFault fault, const MeshReport& report);

}  // namespace laplacian_lines
