// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/line_set.h"
#include "visibility/crease_marks.h"
#include "visibility/picture.h"

namespace laplacian_lines {

/// A segment that may be drawn, or hide others: a mesh edge that is a contour, border, crease or
/// intersection, or a segment of a line on the surface.
struct VisibilitySegment {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::uint32_t points[2] = {0, 0};  ///< of VisibilitySegments
    std::uint32_t edge = kNone;        ///< of the mesh
    std::uint32_t line = kNone;        ///< of VisibilitySegments::lines
    LineKind kind = LineKind::Contour;
    bool is_drawn = true;
    bool is_exact = true;  ///< an edge of the form; others approximate a smooth line
    bool divides = false;  ///< visibility of segments may change where they cross it in the picture
};

/// Points are the mesh's vertices, then those of lines.
struct VisibilitySegments {
    /// A line on the surface, of a set that outlives this.
    struct Line {
        const LineSet* set;
        const Polyline* line;
        std::uint32_t first_point;
    };
    const Picture& picture;
    std::vector<VisibilitySegment> segments;
    std::vector<Line> lines;
    std::vector<Eigen::Vector3d> line_points, line_places;  ///< local; in the picture

    const Eigen::Vector3d& position(std::uint32_t point) const {
        const auto& vertices = picture.mesh().positions;
        return point < vertices.size() ? vertices[point] : line_points[point - vertices.size()];
    }
    const Eigen::Vector3d& projected(std::uint32_t point) const {
        const std::size_t vertices = picture.mesh().positions.size();
        return point < vertices ? picture.vertex(point) : line_places[point - vertices];
    }
    std::uint32_t point_count() const {
        return std::uint32_t(picture.mesh().positions.size() + line_points.size());
    }
    /// The share of a segment's length in space, and the local position, for one in the picture.
    double share_in_space(const VisibilitySegment& segment, double share) const {
        const auto [from, to] = segment.points;
        return picture.share_in_space(projected(from), projected(to), share);
    }
    Eigen::Vector3d position_at(const VisibilitySegment& segment, double share) const {
        const Eigen::Vector3d &a = position(segment.points[0]), &b = position(segment.points[1]);
        return a + share_in_space(segment, share) * (b - a);
    }
};

/// The mesh's edges, then segments of the lines on the surface, in order; contours, borders and
/// creases are edges.
VisibilitySegments find_visibility_segments(const Picture& picture, const CreaseMarks& creases,
                                            const std::vector<LineSet>& lines);

/// Contours, borders and creases.
bool is_edge_kind(LineKind kind);

}  // namespace laplacian_lines
