// SPDX-License-Identifier: GPL-3.0-or-later
// Of what a picture is made, before it is known what is seen:
//  1. Edges of the mesh: contours, borders, contacts of bodies and creases (EdgeClassifier).
//  2. Faces seen edge-on, where the turn of the eye decides what is a contour, get one in any case
//     (EdgeOnFaces).
//  3. Lines on the surface, segment by segment.
#include "visibility/visibility_segments.h"

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
constexpr double kFlatCosine = 0.9986;           // of 3 degrees: surfaces that continue each other

/// Faces seen edge-on, within the angle by which the eye is turned: whether one faces the eye is
/// chance. If it faces away, it has a contour in front. If it faces the eye and is tangent to its
/// neighbours, it has none; its near edge is then made a contour, for the depth jumps there.
class EdgeOnFaces {
public:
    explicit EdgeOnFaces(const Picture& picture) : picture_(picture), mesh_(picture.mesh()) {
        find_edge_on();
        if (is_edge_on_.empty()) return;
        const std::vector<std::uint32_t> edges = edges_of_faces();
        edge_on_ = collect<std::uint32_t>(is_edge_on_.size(), [&](std::uint32_t t, auto& found) {
            if (is_edge_on(t)) found.push_back(t);
        });
        join_faces(edges);
        note_contours(edges);
    }

    /// Whether an edge of two triangles that is no contour is the near edge of such a face, and is
    /// not covered by contours of the face.
    bool drop_at(std::uint32_t edge) const {
        const VisibilityMesh::Side* sides = mesh_.sides_of(edge);
        if (mesh_.side_count(edge) != 2 ||
            is_edge_on(sides[0].triangle) == is_edge_on(sides[1].triangle))
            return false;
        const std::uint32_t triangle = sides[is_edge_on(sides[0].triangle) ? 0 : 1].triangle;
        if (!recedes(edge, triangle)) return false;
        const auto contours = contours_.find(face_of(triangle));
        return contours == contours_.end() || !cover(contours->second, edge);
    }

private:
    bool is_edge_on(std::uint32_t triangle) const {
        return !is_edge_on_.empty() && is_edge_on_[triangle];
    }

    std::uint32_t number_of(std::uint32_t triangle) const {
        return std::uint32_t(std::lower_bound(edge_on_.begin(), edge_on_.end(), triangle) -
                             edge_on_.begin());
    }
    std::uint32_t face_of(std::uint32_t triangle) const { return face_of_[number_of(triangle)]; }

    void find_edge_on() {
        // The given eye is within one turn, one turned in the opposite direction within two.
        const double least = 2 * EyeFrame::turn();
        is_edge_on_.resize(mesh_.triangles.size());
        for_each_element(is_edge_on_.size(), [&](std::size_t t) {
            const Triangle& corners = mesh_.triangles[t];
            const Vector3d to_eye = picture_.frame().towards_eye(mesh_.positions[corners[0]]);
            is_edge_on_[t] = std::abs(mesh_.normal(std::uint32_t(t)).dot(to_eye)) < least;
        });
        if (std::find(is_edge_on_.begin(), is_edge_on_.end(), 1) == is_edge_on_.end())
            is_edge_on_.clear();
    }

    std::vector<std::uint32_t> edges_of_faces() const {
        return collect<std::uint32_t>(
            mesh_.edge_count(), [&](std::uint32_t e, std::vector<std::uint32_t>& found) {
                const VisibilityMesh::Side *begin = mesh_.sides_of(e),
                                           *end = begin + mesh_.side_count(e);
                if (std::any_of(begin, end,
                                [&](const auto& side) { return is_edge_on(side.triangle); }))
                    found.push_back(e);
            });
    }

    void join_faces(const std::vector<std::uint32_t>& edges) {
        DisjointSets faces(edge_on_.size());
        for (const std::uint32_t e : edges) {
            if (mesh_.side_count(e) != 2) continue;
            const std::uint32_t a = mesh_.sides_of(e)[0].triangle,
                                b = mesh_.sides_of(e)[1].triangle;
            if (is_edge_on(a) && is_edge_on(b) &&
                mesh_.normal(a).cross(mesh_.normal(b)).norm() < EyeFrame::turn())
                faces.unite(number_of(a), number_of(b));
        }
        face_of_ = faces.take_roots();
    }

    void note_contours(const std::vector<std::uint32_t>& edges) {
        for (const std::uint32_t e : edges) {
            const VisibilityMesh::Side* sides = mesh_.sides_of(e);
            if (!picture_.is_contour(e)) continue;
            for (std::size_t i = 0; i < mesh_.side_count(e); ++i)
                if (is_edge_on(sides[i].triangle))
                    contours_[face_of(sides[i].triangle)].push_back(e);
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
    const VisibilityMesh& mesh_;
    std::vector<std::uint8_t> is_edge_on_;  // by triangle; empty: none is
    std::vector<std::uint32_t> edge_on_;    // triangles, ascending
    std::vector<std::uint32_t> face_of_;    // by index in edge_on_
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> contours_;  // edges, by face
};

/// Decides what a mesh edge is in a picture.
class EdgeClassifier {
public:
    EdgeClassifier(const Picture& picture, const CreaseMarks& creases)
        : picture_(picture), mesh_(picture.mesh()), creases_(creases), edge_on_(picture) {}

    /// Fills in the segment. Returns whether the edge can be drawn or hide anything.
    bool classify(std::uint32_t edge, VisibilitySegment& segment) const {
        const std::size_t count = mesh_.side_count(edge);
        const bool is_crease = !creases_.empty() && creases_[edge];
        if (count == 1) {
            segment.kind = LineKind::Border;
        } else if (picture_.is_contour(edge)) {
            segment.kind = LineKind::Contour;
            segment.is_exact = is_crease || count > 2;
        } else if (count > 2) {
            classify_contact(edge, segment);
        } else if (!is_crease && edge_on_.drop_at(edge)) {
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
    double rise(std::uint32_t edge, const VisibilityMesh::Side& side) const {
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
        const VisibilityMesh::Side* const sides = mesh_.sides_of(edge);
        const auto comes_before = [&](const VisibilityMesh::Side& a,
                                      const VisibilityMesh::Side& b) {
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
    void classify_contact(std::uint32_t edge, VisibilitySegment& segment) const {
        const bool is_flat = are_flat(first_at(edge, 1), first_at(edge, -1));
        const bool is_one_body = is_flat && is_within_body(edge);
        segment.kind = is_flat && !is_one_body ? LineKind::Contour : LineKind::Crease;
        segment.is_drawn = !is_one_body;
    }

    /// Whether one body has triangles on both sides of an edge in the plane of the nearest one.
    bool is_within_body(std::uint32_t edge) const {
        const std::uint32_t left = first_at(edge, 1);
        const VisibilityMesh::Side* const sides = mesh_.sides_of(edge);
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
    const VisibilityMesh& mesh_;
    const CreaseMarks& creases_;
    const EdgeOnFaces edge_on_;
};

void append_edges(const CreaseMarks& creases, VisibilitySegments& all) {
    const VisibilityMesh& mesh = all.picture.mesh();
    const EyeFrame& frame = all.picture.frame();
    const EdgeClassifier classifier(all.picture, creases);
    const auto is_cut_off = [&](std::uint32_t vertex) {
        return frame.has_perspective() && frame.depth(mesh.positions[vertex]) < kCutOff;
    };
    const auto find = [&](std::uint32_t e, std::vector<VisibilitySegment>& found) {
        VisibilitySegment segment;
        segment.divides = true;
        if (!classifier.classify(e, segment)) return;
        segment.edge = e;
        segment.points[0] = mesh.edges[e].vertices[0];
        segment.points[1] = mesh.edges[e].vertices[1];
        if (is_cut_off(segment.points[0]) && is_cut_off(segment.points[1])) return;
        found.push_back(segment);
    };
    all.segments = collect<VisibilitySegment>(mesh.edge_count(), find);
}

void append_line(const LineSet& set, const Polyline& line, VisibilitySegments& all) {
    const auto first = std::uint32_t(all.picture.mesh().positions.size() + all.line_points.size());
    VisibilitySegment segment;
    segment.line = std::uint32_t(all.lines.size());
    segment.kind = line.kind;
    segment.is_exact = false;
    all.lines.push_back({&set, &line, first});
    const EyeFrame& frame = all.picture.frame();
    const auto is_before = [&](std::uint32_t point) {
        return !frame.has_perspective() || frame.depth(all.position(point)) > kLeastDepth;
    };
    for (std::uint32_t i = 0; i < line.count; ++i) {
        const Vector3d p = set.position(set.points[line.first + i]);
        all.line_points.push_back(all.picture.mesh().local(p));
        all.line_places.push_back(all.picture.frame().project(all.line_points.back()));
        segment.points[0] = segment.points[1];
        segment.points[1] = line.closed && i + 1 == line.count ? first : first + i;
        if (i > 0 && is_before(segment.points[0]) && is_before(segment.points[1]))
            all.segments.push_back(segment);
    }
}

}  // namespace

bool is_edge_kind(LineKind kind) {
    return describe(kind).is_outline || kind == LineKind::Crease;
}

VisibilitySegments find_visibility_segments(const Picture& picture, const CreaseMarks& creases,
                                            const std::vector<LineSet>& lines) {
    VisibilitySegments all{picture, {}, {}, {}, {}};
    append_edges(creases, all);
    for (const LineSet& set : lines)
        for (const Polyline& line : set.lines)
            if (!is_edge_kind(line.kind)) append_line(set, line, all);
    return all;
}

}  // namespace laplacian_lines
