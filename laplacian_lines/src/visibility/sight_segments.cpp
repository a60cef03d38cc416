// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/sight_segments.h"

#include <algorithm>
#include <cmath>

#include "visibility/edge_on_walls.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

constexpr double kCutOff = 1.001 * kLeastDepth;  // edges before it end what is before the eye
constexpr double kCrestReach = 1e-3;
constexpr double kFlatCosine = 0.9986;  // of 3 degrees: sheets that go on into each other

/// What a mesh edge is in a picture.
class EdgeJudge {
public:
    EdgeJudge(const Picture& picture, const CreaseMarks& creases)
        : picture_(picture), mesh_(picture.mesh()), creases_(creases), walls_(picture) {}

    /// Whether the edge can be drawn or hide anything.
    bool judge(std::uint32_t edge, SightSegment& segment) const {
        const std::size_t count = mesh_.side_count(edge);
        const bool is_crease = !creases_.empty() && creases_[edge];
        segment.is_exact = true;
        segment.is_drawn = true;
        segment.divides = true;
        if (count == 1) {
            segment.kind = LineKind::Border;
        } else if (picture_.is_fold(edge)) {
            segment.kind = LineKind::Contour;
            segment.is_exact = is_crease || count > 2;
        } else if (!is_crease && walls_.drop_at(edge)) {
            segment.kind = LineKind::Contour;
            segment.is_exact = segment.divides = false;
        } else {
            segment.kind = count > 2 && is_joint(edge) ? LineKind::Contour : LineKind::Crease;
            segment.divides = count > 2;
            segment.is_drawn = count > 2 ? !goes_on_flat(edge) : is_crease;
        }
        return segment.is_drawn || segment.divides;
    }

private:
    /// How much nearer to the eye a triangle gets across an edge.
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

    /// The triangle that is seen first on a side of an edge.
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

    /// Whether what is seen first on both sides of an edge of several triangles is one plane.
    bool is_flat(std::uint32_t edge) const {
        return are_flat(first_at(edge, 1), first_at(edge, -1));
    }

    /// Whether two bodies touch at an edge of several triangles, flush.
    bool is_joint(std::uint32_t edge) const { return is_flat(edge) && !is_within_body(edge); }

    bool goes_on_flat(std::uint32_t edge) const { return is_flat(edge) && is_within_body(edge); }

    /// Whether one body is on both sides of it, in the plane that is seen first.
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
        if (!judge.judge(e, segment)) return;
        segment.edge = e;
        segment.points[0] = mesh.edges[e].vertices[0];
        segment.points[1] = mesh.edges[e].vertices[1];
        if (is_cut_off(segment.points[0]) && is_cut_off(segment.points[1])) return;
        found.push_back(segment);
    };
    all.segments = collect<SightSegment>(mesh.edge_count(), find);
}

void append_line(const LineSet& lines, const Polyline& line, std::uint32_t number,
                 SightSegments& all) {
    SightSegment segment;
    segment.line = number;
    segment.kind = line.kind;
    segment.is_exact = false;
    const EyeFrame& frame = all.picture.frame();
    const auto is_before = [&](std::uint32_t point) {
        return !frame.has_perspective() || frame.depth(all.position(point)) > kLeastDepth;
    };
    const auto vertices = std::uint32_t(all.picture.mesh().positions.size());
    for (std::uint32_t i = 0; i < line.count; ++i) {
        const auto point = vertices + std::uint32_t(all.line_points.size());
        const Vector3d p = lines.place(lines.points[line.first + i]);
        all.line_points.push_back(all.picture.mesh().local(p));
        all.line_places.push_back(all.picture.frame().place(all.line_points.back()));
        segment.points[0] = segment.points[1];
        segment.points[1] = point;
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
    SightSegments all{picture, {}, {}, {}};
    append_edges(creases, all);
    std::uint32_t number = 0;
    for (const LineSet& set : lines)
        for (const Polyline& line : set.lines) {
            if (!is_edge_kind(line.kind)) append_line(set, line, number, all);
            ++number;
        }
    return all;
}

}  // namespace laplacian_lines
