// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/triangle_graph.h"

namespace laplacian_lines {

/// An edge of the mesh where two triangles meet at an angle.
struct BentEdge {
    std::uint32_t triangle;  ///< one of the two
    unsigned side;           ///< of that triangle
    float angle;             ///< between the normals, degrees
};

/// Whether the surface on both sides agrees: up to some twenty triangles each, within a few heights
/// of the one at the edge or within 1 % of D. Their mean normals have to differ about as much as
/// those at the edge, and the surface must not bend to and fro nearly as much as at the edge.
bool is_edge_of_form(const TriangleGraph& graph, const BentEdge& edge);

}  // namespace laplacian_lines
