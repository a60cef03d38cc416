// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/triangle_mesh.h"

/// Crest lines before angles are measured, straight from their definition in docs/drawing.md, in
/// double precision.
namespace reference {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  ///< vertices of the mesh, sorted

struct RidgeEnd {
    Edge edge;
    Eigen::Vector3d position;  ///< mesh coordinates
    Eigen::Vector3d bend;      ///< k₁ e₁ D, of either sign
    double blur;         ///< share of the edge by which rounding in single precision may move it
    double bend_change;  ///< of the bend along the edge
};

/// What the definition says of a triangle.
struct RidgePiece {
    laplacian_lines::Triangle triangle;  ///< sorted vertices
    bool is_found;                       ///< whether a crest passes; else there are no ends
    bool is_certain;  ///< false: rounding in single precision may decide otherwise
    RidgeEnd ends[2];
};

/// Of all triangles of a mesh without cuts those that a crest passes or may pass, one after the
/// other. `kind`: Ridge or Valley.
std::vector<RidgePiece> ridge_pieces(const laplacian_lines::TriangleMesh& mesh,
                                     const laplacian_lines::Field& field,
                                     laplacian_lines::LineKind kind);

struct RidgeLine {
    std::set<Edge> edges;             ///< that it crosses
    double length;                    ///< mesh units
    bool is_certain;                  ///< no piece in or beside it is uncertain
    std::vector<double> pieces = {};  ///< their lengths
};

/// The pieces that are found, joined where two, no more, meet at an edge.
std::vector<RidgeLine> join_ridges(const std::vector<RidgePiece>& pieces);

}  // namespace reference
