// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/surface_walk.h"

namespace laplacian_lines {

/// Whether an edge is a mere diagonal: whether its two triangles could as well be cut along their
/// other diagonal, which would bend the surface there less than twice as much. An edge of the
/// form cannot: its other diagonal cuts a notch, as it always does where both triangles are parts
/// of larger flat faces.
bool is_mere_diagonal(const TriangleGraph& graph, const TriangleSide& side);

}  // namespace laplacian_lines
