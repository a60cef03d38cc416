// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "clusters/extractor_data.h"
#include "fixed/surface_walk.h"

namespace laplacian_lines {

/// An edge of the mesh that may be drawn as part of a crease. Local coordinates.
struct CreaseEdge {
    static constexpr std::uint32_t kNone = 0xffffffffu;
    /// Noise: never shown. Facet: shown only by styles with an angle as small. Unclear: turns much
    /// more than explained, but a side that is neither flat nor even cannot tell. Weak and strong:
    /// turns more, or at least twice as much. Certain: whatever is around.
    enum class Verdict : std::uint8_t { Noise, Facet, Unclear, Weak, Strong, Certain };

    std::uint32_t side;  ///< of Surface
    std::uint32_t vertices[2];
    Eigen::Vector3f positions[2];
    Eigen::Vector3f normals[2];  ///< of the triangles; as one sees them from the same side
    /// Of the two triangles those that are in one plane with no neighbour; otherwise
    /// kNone.
    std::uint32_t facets[2];
    float angle;  ///< between the normals, degrees
    Verdict verdict = Verdict::Noise;
    /// The largest LineStyle::crease_angle with which it is drawn: its angle, or 40 if that is less
    /// and the faces around do not explain it.
    float shown_up_to = 0;

    float length() const { return length_of(positions[1] - positions[0]); }
    bool is_certain() const { return verdict == Verdict::Certain; }
    bool is_strong() const { return verdict == Verdict::Strong; }
    bool is_unclear() const { return verdict == Verdict::Unclear; }
};

/// All edges that a style with this crease angle, in degrees, or a larger one may draw. The number
/// of threads does not matter.
std::vector<CreaseEdge> find_crease_edges(const ExtractorData& data, const Surface& surface,
                                          float least_angle);

// The tests, in the order of crease_edges.cpp, which names them.

/// Triangles that meet at less, in degrees, are parts of one flat face.
constexpr float kFlat = 0.1f;

/// Whether the surface on both sides agrees: up to some twenty triangles each, within a few heights
/// of the one at the edge or within 1 % of D. Their mean normals have to differ about as much as
/// those at the edge, and the surface must not bend to and fro nearly as much as at the edge.
bool is_edge_of_form(const Surface& surface, const CreaseEdge& edge);

/// Whether an edge is a mere diagonal: whether its two triangles could as well be cut along their
/// other diagonal, which would bend the surface there less than twice as much. An edge of the
/// form cannot: its other diagonal cuts a notch, as it always does where both triangles are parts
/// of larger flat faces.
bool is_mere_diagonal(const Surface& surface, std::uint32_t side);

/// What an edge turns beyond what the surface on both sides explains.
struct CreaseJump {
    float degrees;  ///< 0 or less: all is explained
    /// Whether both sides are flat at first or curve evenly, so that they can tell. Twisted ones do
    /// not.
    bool is_clear;
};

/// A curved face is cut into facets that turn again and again: by a curvature, the angle at an edge
/// over the distance between the centres of its facets. On either side of the edge, the curvature
/// of the edges beyond tells by how much a curved face turns from the middle of its first facet to
/// the edge. Both together are explained. Faces are followed straight across the edge, narrow ones
/// along the edges of the form beside them. The angle is that of signed_angle(), less than
/// kEdgeAngle.
CreaseJump crease_jump(const Surface& surface, std::uint32_t side, float angle);

/// Makes facets of those that no others support. Kept are all that are certain, and others in
/// chains from one such edge to another or around, of which at least half is strong; unclear ones
/// only singly, between others of a chain. Of a mesh that
/// was made also those from one such edge on as far as their angles fall: a crease that runs out,
/// as mitres of fillets do; on a scan, noise beside a bad place falls as well.
void drop_unsupported(std::vector<CreaseEdge>& edges, bool is_made);

}  // namespace laplacian_lines
