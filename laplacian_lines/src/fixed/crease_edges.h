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
    /// Noise: never shown. Facet: shown only by styles with an angle as small. Weak, strong: more
    /// than a quarter, or half, of the angle is unexplained. Unclear: strong, but a side is neither
    /// flat nor evenly curved. Certain: of at least kEdgeAngle. Those after Facet are creases.
    enum class Verdict : std::uint8_t { Noise, Facet, Unclear, Weak, Strong, Certain };

    std::uint32_t side;  ///< of Surface
    std::uint32_t vertices[2];
    Eigen::Vector3f positions[2];
    Eigen::Vector3f normals[2];  ///< of the triangles, both on the side of the first one's
    /// The two triangles; kNone for one with a coplanar neighbour.
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

struct CreaseEdges {
    std::vector<CreaseEdge> edges;
    /// Whether the mesh was designed: FlatFaces::is_cad_mesh(), and no scan that was subdivided.
    bool is_design = false;
    /// Whether it was measured: not designed, and of many triangles, several along each fold.
    bool is_scan = false;
};

/// All edges that some style may draw. The number of threads does not matter.
CreaseEdges find_crease_edges(const ExtractorData& data, const Surface& surface);

// The tests, in the order of crease_edges.cpp, which names them.

/// Triangles that meet at less, in degrees, are parts of one flat face, as by kFlatCosine.
constexpr float kFlat = 0.1f;

/// Whether the surroundings confirm the edge: up to some twenty triangles on each side, within a
/// few heights of the one at the edge or within 1 % of D. Their mean normals have to differ about
/// as much as those at the edge, and their roughness has to be well below the edge's angle.
bool is_edge_of_form(const Surface& surface, const CreaseEdge& edge);

/// Whether an edge is a mere diagonal: whether its two triangles could as well be cut along their
/// other diagonal, which would bend the surface there at most twice as much. An edge of the form
/// cannot: its other diagonal cuts a notch, as it always does where both triangles are parts of
/// larger flat faces.
bool is_mere_diagonal(const Surface& surface, std::uint32_t side);

/// What an edge turns beyond what the surface on both sides explains.
struct CreaseJump {
    float degrees;  ///< 0 or less: all is explained
    /// Whether both sides are flat at first or evenly curved, so that `degrees` can be trusted.
    /// False for twisted faces.
    bool is_clear;
};

/// A curved face is cut into facets that turn again and again: on either side, those beyond predict
/// how much it would turn from the centre of the first one to the edge, and both predictions
/// together are what is explained. Faces are followed straight across the edge, narrow ones along
/// the edges of the form beside them. The angle is that of signed_angle(), less than kEdgeAngle.
CreaseJump crease_jump(const Surface& surface, std::uint32_t side, float angle);

/// Makes facets of edges that no others support. Kept are certain edges; chains that run out from
/// one straight on, as the mitres of fillets do, strong or not; others without loose ends, if at
/// least half of what is connected is strong; unclear edges only singly, within a chain.
void drop_unsupported(std::vector<CreaseEdge>& edges);

}  // namespace laplacian_lines
