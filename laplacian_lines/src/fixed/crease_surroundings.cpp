// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

// How far a side reaches.
constexpr float kLeastReach = 0.01f;  // D
constexpr float kHeights = 2.5f;      // of the triangle at the edge
constexpr std::size_t kMostTriangles = 24;
constexpr float kPassable = 35;  // degrees; sharper edges bound a side

// Least difference of the mean normals of two sides: a share of the edge's angle, or these degrees.
constexpr float kConfirmed = 0.6f;
constexpr float kConfirmedAnyway = 40;

// The roughness of a side is the part of its bending that cancels out.
constexpr float kTimesRoughness = 6;     // least angle of an edge
constexpr float kCertainly = 1.5f;       // times too rough: more triangles would not help
constexpr float kSmootherThanScans = 2;  // degrees; CAD meshes are smoother
constexpr int kFewEdges = 8;             // too few to tell roughness from curvature
constexpr float kLong = 0.02f;           // D; edges this long are no noise

/// Positive where the surface is convex at a side.
float bend_at(const Surface& surface, std::uint32_t side) {
    const Surface::Facet& facet = surface.facet(side / 3);
    return dot(facet.normal, facet.centre - surface.beyond(side).centre);
}

/// The triangles on one side of an edge, in rings from the one at it.
class EdgeSide {
public:
    /// The side of the edge's own triangle, or of the one beyond, up to edges of a cosine below
    /// `passable`; ends early where the surface is too rough for an edge of this angle.
    EdgeSide(const Surface& surface, const CreaseEdge& edge, bool beyond, float passable,
             float angle)
        : surface_(surface), passable_(passable), is_long_(edge.length() > kLong) {
        const std::uint32_t own = edge.side / 3, other = surface.across(edge.side) / 3;
        const std::uint32_t start = beyond ? other : own, opposite = beyond ? own : other;
        const float length = edge.length();
        const float height = length > 0 ? 2 * surface.facet(start).area / length : 0;
        const float farthest = std::max(kLeastReach, kHeights * height) + length / 2;
        const Vector3f middle = (edge.positions[0] + edge.positions[1]) / 2;
        const Vector3f along = unit(edge.positions[1] - edge.positions[0]);
        const Vector3f inwards = edge.normals[0].cross(along);
        const Vector3f outwards = edge.normals[1].cross(-along);
        const Vector3f away = beyond ? outwards - inwards : inwards - outwards;
        // on this side of the bisecting plane of the edge
        const auto is_near = [&](std::uint32_t triangle) {
            const Vector3f offset = surface.facet(triangle).centre - middle;
            return dot(offset, away) > 0 && squared_length_of(offset) <= farthest * farthest;
        };
        std::vector<std::uint32_t> reached = {start};
        std::vector<float> signs = {beyond ? surface.sign_across(edge.side) : 1.f};
        for (std::size_t i = 0; i < reached.size(); ++i) {
            add(reached[i], signs[i]);
            if (!has_few_edges() && is_too_rough(angle / kCertainly)) return;
            for (std::uint32_t side = 3 * reached[i]; side < 3 * reached[i] + 3; ++side) {
                if (reached.size() == kMostTriangles || !surface.has_neighbour(side)) continue;
                const std::uint32_t next = surface.across(side) / 3;
                if (next == opposite || !is_near(next) ||
                    std::find(reached.begin(), reached.end(), next) != reached.end() ||
                    surface.cosine_across(side) < passable)
                    continue;
                signs.push_back(signs[i] * surface.sign_across(side));
                reached.push_back(next);
            }
        }
    }

    bool is_too_rough(float angle) const { return angle < kTimesRoughness * roughness(); }

    /// Whether the surface is too smooth for a scan.
    bool is_smoother_than_scans() const { return edges_ > 0 && roughness() < kSmootherThanScans; }

    /// Whether the mean normals of two sides differ about as much as those at the edge do.
    static bool differ(const EdgeSide& here, const EdgeSide& there, float angle) {
        return degrees_between(here.normals_, there.normals_) >=
               std::min(kConfirmed * angle, kConfirmedAnyway);
    }

private:
    bool has_few_edges() const { return edges_ < kFewEdges; }

    void add(std::uint32_t triangle, float sign) {
        const Surface::Facet& facet = surface_.facet(triangle);
        normals_ += sign * facet.area * facet.normal;
        for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
            if (!surface_.has_neighbour(side)) continue;
            const float cosine = surface_.cosine_across(side);
            if (cosine < passable_) continue;
            const float square = std::max(2 - 2 * cosine, 0.f);  // about that of the angle
            const float size = std::sqrt(square);
            bends_ += sign * bend_at(surface_, side) > 0 ? size : -size;
            sizes_ += size;
            squares_ += square;
            ++edges_;
        }
    }

    /// The root mean square of the angles, degrees, less the share that bends to one side, which
    /// few short edges cannot tell.
    float roughness() const {
        if (!(sizes_ > 0)) return 0;
        const float size = std::sqrt(squares_ / float(edges_)) * kDegrees;
        return has_few_edges() && !is_long_ ? size : size * (1 - std::abs(bends_) / sizes_);
    }

    const Surface& surface_;
    const float passable_;
    const bool is_long_;
    Vector3f normals_ = Vector3f::Zero();        // times areas, as the edge's own triangle has them
    float bends_ = 0, sizes_ = 0, squares_ = 0;  // of angles at edges, radians; the first signed
    int edges_ = 0;
};

}  // namespace

bool is_edge_of_form(const Surface& surface, const CreaseEdge& edge) {
    static const float passable = cosine_of(kPassable / kDegrees);
    constexpr float anything = -2, whatever = 1e6f;  // no bounds, never too rough
    const EdgeSide here(surface, edge, false, passable, edge.angle);
    if (here.is_too_rough(edge.angle)) return false;
    const EdgeSide there(surface, edge, true, passable, edge.angle);
    if (there.is_too_rough(edge.angle) || !EdgeSide::differ(here, there, edge.angle)) return false;
    return (here.is_smoother_than_scans() && there.is_smoother_than_scans()) ||
           EdgeSide::differ(EdgeSide(surface, edge, false, anything, whatever),
                            EdgeSide(surface, edge, true, anything, whatever), edge.angle);
}

}  // namespace laplacian_lines
