// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/sight_segments.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "system/disjoint_sets.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kCutOff = 1.001 * kLeastDepth;  // nearer edges are those of clipping
constexpr double kCrestReach = 1e-3;
constexpr double kFlatCosine = 0.9986;  // of 3 degrees: surfaces that continue each other

/// Faces seen edge-on, within the angle by which the eye is turned: whether one faces the eye is
/// chance. If it faces away, it has a contour in front. If it faces the eye and is tangent to its
/// neighbours, it has none; its near edge is then made a contour, for the depth jumps there.
class EdgeOnWalls {
public:
    explicit EdgeOnWalls(const Picture& picture) : picture_(picture), mesh_(picture.mesh()) {
        find_walls();
        if (is_wall_.empty()) return;
        const std::vector<std::uint32_t> edges = edges_of_walls();
        walls_ = collect<std::uint32_t>(is_wall_.size(), [&](std::uint32_t t, auto& found) {
            if (is_wall(t)) found.push_back(t);
        });
        join_faces(edges);
        note_folds(edges);
    }

    /// Whether an edge of two triangles that is no contour is the near edge of such a face, and is
    /// not covered by contours of the face.
    bool drop_at(std::uint32_t edge) const {
        const SightMesh::Side* sides = mesh_.sides_of(edge);
        if (mesh_.side_count(edge) != 2 || is_wall(sides[0].triangle) == is_wall(sides[1].triangle))
            return false;
        const std::uint32_t wall = sides[is_wall(sides[0].triangle) ? 0 : 1].triangle;
        if (!recedes(edge, wall)) return false;
        const auto folds = folds_.find(face_of(wall));
        return folds == folds_.end() || !cover(folds->second, edge);
    }

private:
    bool is_wall(std::uint32_t triangle) const { return !is_wall_.empty() && is_wall_[triangle]; }

    std::uint32_t number_of(std::uint32_t wall) const {
        return std::uint32_t(std::lower_bound(walls_.begin(), walls_.end(), wall) - walls_.begin());
    }
    std::uint32_t face_of(std::uint32_t wall) const { return face_of_[number_of(wall)]; }

    void find_walls() {
        // The given eye is within one turn, one turned in the opposite direction within two.
        const double least = 2 * EyeFrame::turn();
        is_wall_.resize(mesh_.triangles.size());
        for_each_element(is_wall_.size(), [&](std::size_t t) {
            const Triangle& corners = mesh_.triangles[t];
            const Vector3d to_eye = picture_.frame().towards_eye(mesh_.positions[corners[0]]);
            is_wall_[t] = std::abs(mesh_.normal(std::uint32_t(t)).dot(to_eye)) < least;
        });
        if (std::find(is_wall_.begin(), is_wall_.end(), 1) == is_wall_.end()) is_wall_.clear();
    }

    std::vector<std::uint32_t> edges_of_walls() const {
        return collect<std::uint32_t>(mesh_.edge_count(), [&](std::uint32_t e,
                                                              std::vector<std::uint32_t>& found) {
            const SightMesh::Side *begin = mesh_.sides_of(e), *end = begin + mesh_.side_count(e);
            if (std::any_of(begin, end, [&](const auto& side) { return is_wall(side.triangle); }))
                found.push_back(e);
        });
    }

    void join_faces(const std::vector<std::uint32_t>& edges) {
        DisjointSets faces(walls_.size());
        for (const std::uint32_t e : edges) {
            if (mesh_.side_count(e) != 2) continue;
            const std::uint32_t a = mesh_.sides_of(e)[0].triangle,
                                b = mesh_.sides_of(e)[1].triangle;
            if (is_wall(a) && is_wall(b) &&
                mesh_.normal(a).cross(mesh_.normal(b)).norm() < EyeFrame::turn())
                faces.unite(number_of(a), number_of(b));
        }
        face_of_ = faces.take_roots();
    }

    void note_folds(const std::vector<std::uint32_t>& edges) {
        for (const std::uint32_t e : edges) {
            const SightMesh::Side* sides = mesh_.sides_of(e);
            if (!picture_.is_fold(e)) continue;
            for (std::size_t i = 0; i < mesh_.side_count(e); ++i)
                if (is_wall(sides[i].triangle)) folds_[face_of(sides[i].triangle)].push_back(e);
        }
    }

    /// Whether a triangle recedes from the eye away from its edge.
    bool recedes(std::uint32_t edge, std::uint32_t triangle) const {
        const auto& ends = mesh_.edges[edge].vertices;
        const Vector3d &a = picture_.vertex(ends[0]), span = picture_.vertex(ends[1]) - a;
        const Vector3d normal =
            span.cross(Vector3d::UnitZ()).cross(span);  // to the eye, off the edge
        const Triangle& t = mesh_.triangles[triangle];
        return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
            return v == ends[0] || v == ends[1] || normal.dot(picture_.vertex(v) - a) < 0;
        });
    }

    /// Whether edges of a face, which is a line in the picture, together cover another of its
    /// edges.
    bool cover(const std::vector<std::uint32_t>& edges, std::uint32_t other) const {
        const auto at = [&](std::uint32_t e, int end) -> Vector2d {
            return picture_.vertex(mesh_.edges[e].vertices[end]).head<2>();
        };
        const Vector2d a = at(other, 0), span = at(other, 1) - a;
        std::vector<std::pair<double, double>> parts;  // of the span, from 0 to its squared length
        for (const std::uint32_t edge : edges)
            parts.push_back(std::minmax({span.dot(at(edge, 0) - a), span.dot(at(edge, 1) - a)}));
        std::sort(parts.begin(), parts.end());
        const double touch = EyeFrame::turn() * span.norm();  // of edges seen end-on
        double covered = 0;
        for (const auto& [low, high] : parts)
            if (low <= covered + touch) covered = std::max(covered, high);
        return covered >= span.squaredNorm() - touch;
    }

    const Picture& picture_;
    const SightMesh& mesh_;
    std::vector<std::uint8_t> is_wall_;   // by triangle; empty: none is
    std::vector<std::uint32_t> walls_;    // triangles, ascending
    std::vector<std::uint32_t> face_of_;  // by index in walls_
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> folds_;  // edges, by face
};

/// Decides what a mesh edge is in a picture.
class EdgeJudge {
public:
    EdgeJudge(const Picture& picture, const CreaseMarks& creases)
        : picture_(picture), mesh_(picture.mesh()), creases_(creases), walls_(picture) {}

    /// Fills in the segment. Returns whether the edge can be drawn or hide anything.
    bool judge(std::uint32_t edge, SightSegment& segment) const {
        const std::size_t count = mesh_.side_count(edge);
        const bool is_crease = !creases_.empty() && creases_[edge];
        if (count == 1) {
            segment.kind = LineKind::Border;
        } else if (picture_.is_fold(edge)) {
            segment.kind = LineKind::Contour;
            segment.is_exact = is_crease || count > 2;
        } else if (count > 2) {
            judge_contact(edge, segment);
        } else if (!is_crease && walls_.drop_at(edge)) {
            segment.kind = LineKind::Contour;
            segment.is_exact = segment.divides = false;
        } else {
            segment.kind = LineKind::Crease;
            segment.is_drawn = is_crease;
            segment.divides = false;
        }
        return segment.is_drawn || segment.divides;
    }

private:
    /// Slope of a triangle towards the eye, across an edge and away from it.
    double rise(std::uint32_t edge, const SightMesh::Side& side) const {
        const Triangle& t = mesh_.triangles[side.triangle];
        const Vector3d &a = picture_.vertex(t[0]), &b = picture_.vertex(t[1]),
                       &c = picture_.vertex(t[2]);
        const Vector3d normal = (b - a).cross(c - a);
        const Vector3d span = picture_.vertex(mesh_.edges[edge].vertices[1]) -
                              picture_.vertex(mesh_.edges[edge].vertices[0]);
        const double sign = picture_.side_of(side);
        return -sign * (normal.x() * -span.y() + normal.y() * span.x()) / normal.z();
    }

    /// The triangle nearest to the eye on a side of an edge.
    std::uint32_t first_at(std::uint32_t edge, int side) const {
        const SightMesh::Side* const sides = mesh_.sides_of(edge);
        const auto comes_before = [&](const SightMesh::Side& a, const SightMesh::Side& b) {
            const bool is_a = picture_.side_of(a) == side, is_b = picture_.side_of(b) == side;
            return is_a != is_b ? is_b : rise(edge, a) < rise(edge, b);
        };
        return std::max_element(sides, sides + mesh_.side_count(edge), comes_before)->triangle;
    }

    bool are_flat(std::uint32_t a, std::uint32_t b) const {
        return std::abs(mesh_.normal(a).dot(mesh_.normal(b))) > kFlatCosine;
    }

    /// For edges of more than two triangles. If the nearest ones on both sides are coplanar, they
    /// belong to one body, and nothing is drawn, or to two that touch.
    void judge_contact(std::uint32_t edge, SightSegment& segment) const {
        const bool is_flat = are_flat(first_at(edge, 1), first_at(edge, -1));
        const bool is_one_body = is_flat && is_within_body(edge);
        segment.kind = is_flat && !is_one_body ? LineKind::Contour : LineKind::Crease;
        segment.is_drawn = !is_one_body;
    }

    /// Whether one body has triangles on both sides of an edge in the plane of the nearest one.
    bool is_within_body(std::uint32_t edge) const {
        const std::uint32_t left = first_at(edge, 1);
        const SightMesh::Side* const sides = mesh_.sides_of(edge);
        const auto is_there = [&](int side, std::uint32_t body) {
            return std::any_of(sides, sides + mesh_.side_count(edge), [&](const auto& other) {
                return picture_.side_of(other) == side && mesh_.bodies[other.triangle] == body &&
                       are_flat(other.triangle, left);
            });
        };
        return std::any_of(sides, sides + mesh_.side_count(edge), [&](const auto& side) {
            const std::uint32_t body = mesh_.bodies[side.triangle];
            return is_there(1, body) && is_there(-1, body);
        });
    }

    const Picture& picture_;
    const SightMesh& mesh_;
    const CreaseMarks& creases_;
    const EdgeOnWalls walls_;
};

void append_edges(const CreaseMarks& creases, SightSegments& all) {
    const SightMesh& mesh = all.picture.mesh();
    const EyeFrame& frame = all.picture.frame();
    const EdgeJudge judge(all.picture, creases);
    const auto is_cut_off = [&](std::uint32_t vertex) {
        return frame.has_perspective() && frame.depth(mesh.positions[vertex]) < kCutOff;
    };
    const auto find = [&](std::uint32_t e, std::vector<SightSegment>& found) {
        SightSegment segment;
        segment.divides = true;
        if (!judge.judge(e, segment)) return;
        segment.edge = e;
        segment.points[0] = mesh.edges[e].vertices[0];
        segment.points[1] = mesh.edges[e].vertices[1];
        if (is_cut_off(segment.points[0]) && is_cut_off(segment.points[1])) return;
        found.push_back(segment);
    };
    all.segments = collect<SightSegment>(mesh.edge_count(), find);
}

void append_line(const LineSet& set, const Polyline& line, SightSegments& all) {
    const auto first = std::uint32_t(all.picture.mesh().positions.size() + all.line_points.size());
    SightSegment segment;
    segment.line = std::uint32_t(all.lines.size());
    segment.kind = line.kind;
    segment.is_exact = false;
    all.lines.push_back({&set, &line, first});
    const EyeFrame& frame = all.picture.frame();
    const auto is_before = [&](std::uint32_t point) {
        return !frame.has_perspective() || frame.depth(all.position(point)) > kLeastDepth;
    };
    for (std::uint32_t i = 0; i < line.count; ++i) {
        const Vector3d p = set.place(set.points[line.first + i]);
        all.line_points.push_back(all.picture.mesh().local(p));
        all.line_places.push_back(all.picture.frame().place(all.line_points.back()));
        segment.points[0] = segment.points[1];
        segment.points[1] = line.closed && i + 1 == line.count ? first : first + i;
        if (i > 0 && is_before(segment.points[0]) && is_before(segment.points[1]))
            all.segments.push_back(segment);
    }
}

}  // namespace

double reach_of(const SightMesh& mesh, const SightSegment& segment) {
    if (segment.edge != SightSegment::kNone) return mesh.precision;
    const bool is_crest = !describe(segment.kind).depends_on_view;
    return mesh.line_precision + (is_crest ? kCrestReach : 0);
}

bool is_edge_kind(LineKind kind) {
    return describe(kind).is_outline || kind == LineKind::Crease;
}

SightSegments find_sight_segments(const Picture& picture, const CreaseMarks& creases,
                                  const std::vector<LineSet>& lines) {
    SightSegments all{picture, {}, {}, {}, {}};
    append_edges(creases, all);
    for (const LineSet& set : lines)
        for (const Polyline& line : set.lines)
            if (!is_edge_kind(line.kind)) append_line(set, line, all);
    return all;
}

}  // namespace laplacian_lines
