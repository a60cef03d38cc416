// SPDX-License-Identifier: GPL-3.0-or-later
// When an edge of the mesh is a crease, test by test. The angle of an edge is that between the
// normals of its two triangles.
//  1. The angle is at least 3 degrees on a CAD mesh, 20 on a scan.
//  2. On a scan, the mean normals of both sides differ by about that angle: is_edge_of_form().
//  3. From 40 degrees on the edge is then certain. Others
//  4. are not just a diagonal of a bent quad: is_mere_diagonal(),
//  5. turn more than the curvature on both sides explains: crease_jump(),
//  6. and are connected with other creases: drop_unsupported().
// creases.cpp decides which of these are long and smooth enough to be drawn.
#include "fixed/crease_edges.h"

#include <algorithm>
#include <cmath>

#include "mesh/flat_faces.h"
#include "system/parallel.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;
using Verdict = CreaseEdge::Verdict;

// Modelled faces that are meant to be one meet at angles up to this.
constexpr float kLeastCreaseAngle = 3;     // degrees
constexpr float kLeastShownAngle = 20;     // degrees, the least LineStyle::crease_angle
constexpr float kLeastMeasuredAngle = 20;  // degrees, of scans: a smaller one may be noise
// Unexplained shares of the edge's angle: 0 at a facet of a curved face, 1 between flat faces. An
// edge that continues a strong one may be weak.
constexpr float kStrong = 0.5f, kWeak = 0.25f;

constexpr std::uint32_t kLeastOfScan = 1000;  // triangles; of fewer, single edges may be the form's

// Samples for share_of_triangular_faces().
constexpr std::uint32_t kMostPlaces = 4000;
constexpr std::size_t kMostParts = 256;   // a triangle subdivided four times
constexpr float kSameDirection = 0.999f;  // cosine

/// Whether the flat face around a triangle is itself a triangle: its boundary has three directions.
bool is_triangle(const Surface& surface, std::uint32_t triangle, float flat) {
    std::vector<std::uint32_t> parts = {triangle};
    std::vector<float> signs = {1};  // of normals, so that all point to one side
    std::vector<Vector3f> directions;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::uint32_t side = 3 * parts[i]; side < 3 * parts[i] + 3; ++side) {
            if (surface.has_neighbour(side) && surface.cosine_across(side) >= flat) {
                const std::uint32_t next = surface.across(side) / 3;
                if (std::find(parts.begin(), parts.end(), next) != parts.end()) continue;
                if (parts.size() == kMostParts) return false;
                parts.push_back(next);
                signs.push_back(signs[i] * surface.sign_across(side));
                continue;
            }
            const Vector3f direction = signs[i] * unit(surface.span(side));
            const auto is_same = [&](const Vector3f& d) {
                return dot(d, direction) > kSameDirection;
            };
            if (std::any_of(directions.begin(), directions.end(), is_same)) continue;
            if (directions.size() == 3) return false;
            directions.push_back(direction);
        }
    return directions.size() == 3;
}

/// Estimates, from samples all over the mesh, the share of triangular ones in the area of flat
/// faces of several triangles, 0 to 1: nearly 1 where a scan was subdivided. `flat`: least cosine
/// between triangles of one face.
double share_of_triangular_faces(const Surface& surface, float flat) {
    const std::uint32_t step = surface.triangle_count() / kMostPlaces + 1;
    double all = 0, triangular = 0;
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); triangle += step) {
        if (!surface.has_coplanar_neighbour(triangle, flat)) continue;
        const double area = double(surface.facet(triangle).area);
        all += area;
        if (is_triangle(surface, triangle, flat)) triangular += area;
    }
    return all > 0 ? triangular / all : 0;
}

class CreaseFinder {
public:
    CreaseFinder(const ExtractorData& data, const Surface& surface)
        : surface_(surface), is_cad_(data.is_cad && !is_subdivided(data.flat_share)) {}

    CreaseEdges run() const {
        std::vector<CreaseEdge> edges = find_bent_edges();
        in_parallel(edges.size(), [&](std::size_t i) { edges[i].verdict = test(edges[i]); });
        drop_unsupported(edges);
        for (CreaseEdge& edge : edges)
            if (edge.verdict != Verdict::Noise)
                edge.shown_up_to =
                    edge.verdict == Verdict::Facet ? edge.angle : std::max(kEdgeAngle, edge.angle);
        const auto is_used = [&](std::uint32_t i) {
            return edges[i].shown_up_to >= kLeastShownAngle;
        };
        return {kept(edges, is_used), is_cad_,
                !is_cad_ && surface_.triangle_count() >= kLeastOfScan};
    }

private:
    /// Whether flat faces are those into which triangles of a scan were cut.
    bool is_subdivided(double flat_share) const {
        return flat_share > kCadShare &&
               (1 - share_of_triangular_faces(surface_, flat_)) * flat_share <= kCadShare;
    }

    std::vector<CreaseEdge> find_bent_edges() const {
        const float bent =
            cosine_of((is_cad_ ? kLeastCreaseAngle : kLeastMeasuredAngle) / kDegrees);
        const auto find = [&](std::uint32_t side, std::vector<CreaseEdge>& found) {
            if (!surface_.has_neighbour(side) || surface_.across(side) < side) return;
            const float cosine = surface_.cosine_across(side);
            if (cosine <= bent && surface_.facet(side / 3).area > 0)
                found.push_back(make_edge(side, cosine));
        };
        return collect<CreaseEdge>(surface_.sides().side_count(), find);
    }

    CreaseEdge make_edge(std::uint32_t side, float cosine) const {
        const auto facet = [&](std::uint32_t t) {
            return surface_.has_coplanar_neighbour(t, flat_) ? CreaseEdge::kNone : t;
        };
        const std::uint32_t begin = surface_.begin(side), end = surface_.end(side);
        return {side,
                {begin, end},
                {surface_.position(begin), surface_.position(end)},
                {surface_.facet(side / 3).normal,
                 surface_.sign_across(side) * surface_.beyond(side).normal},
                {facet(side / 3), facet(surface_.across(side) / 3)},
                float(std::acos(std::max(double(cosine), -1.))) * kDegrees};
    }

    Verdict test(const CreaseEdge& edge) const {
        if (!is_cad_ && !is_edge_of_form(surface_, edge)) return Verdict::Noise;
        if (edge.angle >= kEdgeAngle) return Verdict::Certain;
        if (is_mere_diagonal(surface_, edge.side)) return Verdict::Facet;
        const CreaseJump jump = crease_jump(surface_, edge.side, signed_angle(surface_, edge.side));
        if (jump.degrees <= std::max(kLeastCreaseAngle, kWeak * edge.angle)) return Verdict::Facet;
        const bool is_strong = jump.degrees > kStrong * edge.angle;
        if (!jump.is_clear) return is_strong ? Verdict::Unclear : Verdict::Facet;
        return is_strong ? Verdict::Strong : Verdict::Weak;
    }

    const float flat_ = cosine_of(kFlat / kDegrees);
    const Surface& surface_;
    const bool is_cad_;
};

}  // namespace

CreaseEdges find_crease_edges(const ExtractorData& data, const Surface& surface) {
    return CreaseFinder(data, surface).run();
}

}  // namespace laplacian_lines
