// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "fixed/surface_walk.h"
#include "fixed/triangle_graph.h"
#include "system/three_floats.h"

/// What tells edges of the form from those between facets.
namespace laplacian_lines {

/// What an edge turns beyond what the surface on both sides explains.
struct CreaseJump {
    float degrees;  ///< 0 or less: all is explained
    /// Whether both sides are flat at first or curve evenly, so that they can tell. Twisted ones do
    /// not.
    bool is_clear;
};

/// Triangles that meet at less, in degrees, are parts of one flat face.
constexpr float kFlat = 0.1f;

/// A curved face is cut into facets that turn again and again: by a curvature, the angle at an edge
/// over the distance between the centres of its facets. On either side of the edge, the curvature
/// of the edges beyond tells by how much a curved face turns from the middle of its first facet to
/// the edge. Both together are explained. Faces are followed straight across the edge, narrow ones
/// along the edges of the form beside them. The angle is that of signed_angle(), less than
/// kEdgeAngle.
CreaseJump crease_jump(const TriangleGraph& graph, const TriangleSide& side, float angle);

/// Whether an edge is a mere diagonal: whether its two triangles could as well be cut along their
/// other diagonal, which would bend the surface there less than twice as much. An edge of the
/// form cannot: its other diagonal cuts a notch, as it always does where both triangles are parts
/// of larger flat faces.
bool is_mere_diagonal(const TriangleGraph& graph, const TriangleSide& side);

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

/// Flat faces that are triangles themselves, of several triangles of the mesh: as good as all flat
/// faces where the triangles of a scan were subdivided.
struct TriangularFaces {
    double share = 0;  ///< of the area of flat faces of several triangles, 0 to 1
    double parts = 1;  ///< triangles of the mesh in one of them, on the mean
};

/// Flat is what meets at this cosine or more. By some places all over the mesh.
TriangularFaces find_triangular_faces(const TriangleGraph& graph, float flat);

/// An edge that is taken for one of the form, or may be.
struct PossibleCrease {
    std::array<std::uint32_t, 2> vertices;
    std::array<Eigen::Vector3f, 2> positions;
    float angle;  ///< degrees
    bool is_certain;
    bool is_strong;   ///< of one that is not certain: at least half of its angle is unexplained
    bool is_unclear;  ///< of one that is not certain: what is around cannot tell

    float length() const { return length_of(positions[1] - positions[0]); }
};

/// Which of them are edges of the form: all that are certain, and others in chains from one such
/// edge to another or around, of which at least half is strong; unclear ones only singly, between
/// others of a chain. Of a mesh that was made also those from one such edge on as far as their
/// angles fall: a crease that runs out, as mitres of fillets do; on a scan, noise beside a bad
/// place falls as well.
std::vector<std::uint8_t> find_supported(const std::vector<PossibleCrease>& edges, bool is_made);

}  // namespace laplacian_lines
