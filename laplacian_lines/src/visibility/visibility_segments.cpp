// SPDX-License-Identifier: GPL-3.0-or-later
// Of what a picture is made, before it is known what is seen:
//  1. Edges of the mesh: contours, borders, contacts of bodies and creases (EdgeClassifier).
//  2. A face seen edge-on gets a contour however the turn of the eye happens to decide
//     (EdgeOnFaces).
//  3. Lines on the surface, segment by segment.
#include "visibility/visibility_segments.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "visibility/edge_on_faces.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

constexpr double kCutOff = 1.001 * kLeastDepth;  // edges made by clipping are nearer
constexpr double kSmoothCosine = 0.9986;         // of 3 degrees: surfaces that continue each other

/// Decides what a mesh edge is in a picture.
class EdgeClassifier {
public:
    EdgeClassifier(const Picture& picture, const CreaseMarks& creases)
        : picture_(picture), mesh_(picture.mesh()), creases_(creases), edge_on_(picture) {}

    /// Fills in what the segment is. Returns whether the edge can be drawn or hide anything.
    bool classify(std::uint32_t edge, VisibilitySegment& segment) const {
        segment.divides = true;
        const std::size_t count = mesh_.side_count(edge);
        const bool is_crease = !creases_.empty() && creases_[edge];
        if (count == 1) {
            segment.kind = LineKind::Border;
        } else if (picture_.is_contour(edge)) {
            segment.kind = LineKind::Contour;
            segment.is_exact = is_crease || count > 2;
        } else if (count > 2) {
            classify_contact(edge, segment);
        } else if (edge_on_.needs_contour(edge)) {
            segment.kind = LineKind::Contour;
            segment.is_exact = is_crease;
            segment.divides = false;
        } else {
            segment.kind = LineKind::Crease;
            segment.is_drawn = is_crease;
            segment.divides = false;
        }
        return segment.is_drawn || segment.divides;
    }

private:
    /// Slope of a triangle towards the eye, away from an edge and across it, times its length.
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
        const auto is_farther = [&](const VisibilityMesh::Side& a, const VisibilityMesh::Side& b) {
            const bool is_a = picture_.side_of(a) == side, is_b = picture_.side_of(b) == side;
            return is_a != is_b ? is_b : rise(edge, a) < rise(edge, b);
        };
        return std::max_element(sides, sides + mesh_.side_count(edge), is_farther)->triangle;
    }

    bool are_coplanar(std::uint32_t a, std::uint32_t b) const {
        return std::abs(mesh_.normal(a).dot(mesh_.normal(b))) > kSmoothCosine;
    }

    /// For edges of more than two triangles. If the nearest ones on both sides are coplanar, they
    /// belong to one body, and nothing is drawn, or to two that touch.
    void classify_contact(std::uint32_t edge, VisibilitySegment& segment) const {
        const std::uint32_t left = first_at(edge, 1);
        const bool is_flat = are_coplanar(left, first_at(edge, -1));
        const bool is_one_body = is_flat && is_within_body(edge, left);
        segment.kind = is_flat && !is_one_body ? LineKind::Contour : LineKind::Crease;
        segment.is_drawn = !is_one_body;
    }

    /// Whether one body has triangles on both sides of an edge in the plane of this triangle.
    bool is_within_body(std::uint32_t edge, std::uint32_t triangle) const {
        const VisibilityMesh::Side* const sides = mesh_.sides_of(edge);
        const auto is_there = [&](int side, std::uint32_t body) {
            return std::any_of(sides, sides + mesh_.side_count(edge), [&](const auto& other) {
                return picture_.side_of(other) == side && mesh_.bodies[other.triangle] == body &&
                       are_coplanar(other.triangle, triangle);
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
    const std::uint32_t first = all.point_count();
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
        all.line_places.push_back(frame.project(all.line_points.back()));
        segment.points[0] = segment.points[1];
        segment.points[1] = line.closed && i + 1 == line.count ? first : first + i;
        if (i > 0 && is_before(segment.points[0]) && is_before(segment.points[1]))
            all.segments.push_back(segment);
    }
}

}  // namespace

bool is_edge_kind(LineKind kind) {
    return describe(kind).bounds_form || kind == LineKind::Crease;
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
