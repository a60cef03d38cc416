// SPDX-License-Identifier: GPL-3.0-or-later
// Segments are divided at their crossings, and a ray through the middle of a piece decides whether
// it is hidden. Pieces of a line on the surface that nothing crosses have the same answer, so a run
// of them needs one ray. Rays are cast in an order in which they read the same memory.
#include "visibility/visibility_pieces.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "mesh/curve_order.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

constexpr double kBeside = 1e-5;  // D: a third of what the turn of the eye moves
// Cosines of normals to the way to the eye: of walls seen edge-on at most, of the face at their
// foot at least.
constexpr double kEdgeOn = 0.05, kFacing = 0.3;

/// A crossing on a segment.
struct Division {
    std::uint32_t segment;
    double share;
    std::uint32_t crossing;
};

/// By segment, in its direction.
std::vector<Division> find_divisions(const std::vector<PictureCrossing>& crossings) {
    std::vector<Division> divisions;
    for (std::uint32_t c = 0; c < crossings.size(); ++c)
        for (int i = 0; i < 2; ++i)
            divisions.push_back({crossings[c].segments[i], crossings[c].shares[i], c});
    std::sort(divisions.begin(), divisions.end(), [](const Division& a, const Division& b) {
        return std::tie(a.segment, a.share, a.crossing) < std::tie(b.segment, b.share, b.crossing);
    });
    return divisions;
}

Eigen::Vector2f middle_of(const VisibilitySegments& all, const VisibilityPiece& piece) {
    const VisibilitySegment& segment = all.segments[piece.segment];
    const double t = (piece.shares[0] + piece.shares[1]) / 2;
    const Vector3d &a = all.projected(segment.points[0]), &b = all.projected(segment.points[1]);
    return (a + t * (b - a)).head<2>().cast<float>();
}

/// Whether the foot of a wall that is seen edge-on is hidden by no more than the wall's unevenness:
/// the face at the foot is seen right beside it.
bool is_foot_seen(const VisibilitySegments& all, const VisibilitySegment& segment,
                  const Vector3d& point, std::uint32_t& occluder) {
    const VisibilityMesh& mesh = all.picture.mesh();
    if (mesh.side_count(segment.edge) != 2) return false;
    const VisibilityMesh::Side* const sides = mesh.sides_of(segment.edge);
    const Vector3d to_eye = all.picture.frame().towards_eye(point);
    const auto facing = [&](int i) { return std::abs(mesh.normal(sides[i].triangle).dot(to_eye)); };
    const int wall = facing(0) < facing(1) ? 0 : 1;
    const VisibilityMesh::Side& face = sides[1 - wall];
    if (facing(wall) > kEdgeOn || facing(1 - wall) < kFacing) return false;
    const Vector3d &a = all.position(segment.points[0]), &b = all.position(segment.points[1]);
    const Vector3d inwards =
        (face.is_reversed ? 1 : -1) * (b - a).cross(mesh.normal(face.triangle)).normalized();
    return !all.picture.cast_ray(point + kBeside * inwards, &face, 1, mesh.precision, occluder)
                .is_hidden;
}

/// Decides about a piece by a ray through its middle; `occluder`: see Picture::cast_ray().
void decide(const VisibilitySegments& all, VisibilityPiece& piece, std::uint32_t& occluder) {
    const VisibilitySegment& segment = all.segments[piece.segment];
    const VisibilityMesh& mesh = all.picture.mesh();
    const Vector3d point = all.position_at(segment, (piece.shares[0] + piece.shares[1]) / 2);
    const bool is_edge = segment.edge != VisibilitySegment::kNone;
    RayHits hits = all.picture.cast_ray(point, is_edge ? mesh.sides_of(segment.edge) : nullptr,
                                        is_edge ? mesh.side_count(segment.edge) : 0,
                                        is_edge ? mesh.precision : mesh.line_precision, occluder);
    if (hits.is_hidden && is_edge && segment.is_exact)
        hits.is_hidden = !is_foot_seen(all, segment, point, occluder);
    piece.is_hidden = hits.is_hidden;
    // of a crease at a face seen edge-on the ray, which leaves out that face, finds what is inside
    const bool is_crease =
        segment.kind == LineKind::Contour && segment.is_exact && !segment.divides;
    piece.gap = is_crease ? 0 : float(hits.gap);
    piece.is_outline = !hits.is_hidden && std::isinf(hits.gap) && segment.divides &&
                       describe(segment.kind).bounds_form;
}

/// Whether a piece continues the one before as an uncrossed line on the surface.
bool continues(const VisibilitySegments& all, std::uint32_t first_crossing,
               const VisibilityPiece& before, const VisibilityPiece& piece) {
    const VisibilitySegment &from = all.segments[before.segment], &to = all.segments[piece.segment];
    return to.edge == VisibilitySegment::kNone && from.line == to.line &&
           before.nodes[1] == piece.nodes[0] && piece.nodes[0] < first_crossing;
}

/// The first pieces of runs that are visible or hidden as a whole, and the end of the last.
std::vector<std::size_t> runs_of(const VisibilitySegments& all, std::uint32_t first_crossing,
                                 const std::vector<VisibilityPiece>& pieces) {
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (i == 0 || !continues(all, first_crossing, pieces[i - 1], pieces[i]))
            begins.push_back(i);
    begins.push_back(pieces.size());
    return begins;
}

/// Decides about each run by one piece of it.
void decide_runs(const VisibilitySegments& all, const std::vector<std::size_t>& runs,
                 const StageProgress& stage, std::vector<VisibilityPiece>& pieces) {
    const auto chosen = [&](std::size_t run) -> VisibilityPiece& {
        return pieces[(runs[run] + runs[run + 1]) / 2];
    };
    Eigen::AlignedBox2f bounds;
    for (std::size_t run = 0; run + 1 < runs.size(); ++run)
        bounds.extend(middle_of(all, chosen(run)));
    const std::vector<std::uint32_t> order = order_along_curve<2>(
        runs.size() - 1, bounds, [&](std::uint32_t run) { return middle_of(all, chosen(run)); });
    struct Occluder {
        std::uint32_t triangle = 0;
    };
    parallel_for<Occluder>(
        order.size(), stage,
        [&](std::size_t i, Occluder& occluder) {
            const std::uint32_t run = order[i];
            decide(all, chosen(run), occluder.triangle);
            for (std::size_t k = runs[run]; k < runs[run + 1]; ++k)
                pieces[k].is_hidden = chosen(run).is_hidden;
        },
        256);  // rays
}

}  // namespace

std::vector<VisibilityPiece> find_visibility_pieces(const VisibilitySegments& all,
                                                    const std::vector<PictureCrossing>& crossings,
                                                    const StageProgress& stage) {
    const std::vector<Division> divisions = find_divisions(crossings);
    auto division = divisions.begin();
    const std::uint32_t first_crossing = all.point_count();
    std::vector<VisibilityPiece> pieces;
    for (std::uint32_t s = 0; s < all.segments.size(); ++s) {
        const VisibilitySegment& segment = all.segments[s];
        if (!segment.is_drawn) continue;
        VisibilityPiece piece{s, {segment.points[0], 0}, {0, 0}, false, false, 0};
        const auto end_at = [&](std::uint32_t node, double share) {
            piece.nodes[1] = node;
            piece.shares[1] = share;
            pieces.push_back(piece);
            piece.nodes[0] = node;
            piece.shares[0] = share;
        };
        while (division != divisions.end() && division->segment < s)
            ++division;
        for (; division != divisions.end() && division->segment == s; ++division)
            end_at(first_crossing + division->crossing, division->share);
        end_at(segment.points[1], 1);
    }
    decide_runs(all, runs_of(all, first_crossing, pieces), stage, pieces);
    return pieces;
}

}  // namespace laplacian_lines
