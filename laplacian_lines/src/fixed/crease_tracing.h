// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "clusters/extractor_data.h"
#include "laplacian_lines/line_set.h"
#include "system/three_floats.h"

namespace laplacian_lines {

/// An edge of the mesh that may be drawn as part of a crease. Local coordinates.
struct CreaseEdge {
    std::uint32_t vertices[2];
    Eigen::Vector3f positions[2];
    Eigen::Vector3f normals[2];  ///< of the triangles; as one sees them from the same side
    /// Of the two triangles those that are in one plane with no neighbour; otherwise
    /// TriangleGraph::kNone.
    std::uint32_t facets[2];
    float angle;  ///< between the normals, degrees
    /// The largest LineStyle::crease_angle with which it is drawn: its angle, or 40 if that is less
    /// and the faces around do not explain it.
    float shown_up_to;

    float length() const { return length_of(positions[1] - positions[0]); }
};

/// All edges that a style with this crease angle, in degrees, or a larger one may draw. The number
/// of threads does not matter.
std::vector<CreaseEdge> find_crease_edges(const ExtractorData& data, float least_angle);

/// The creases that a style's angle leaves, joined to lines.
struct TracedCreases {
    float least_angle;  ///< of the style
    LineSet lines;      ///< points in mesh coordinates; gradient: the larger angle of the edges
    /// Which edge goes on from a point to the next one of its line, by point; none from the last.
    std::vector<const CreaseEdge*> edges;
    /// What belongs together: all lines that are connected with a line, or a line with a loose end
    /// alone, by line.
    struct Net {
        std::uint32_t pieces = 0;  ///< straight ones, of one edge or several
        float length = 0;          ///< D
        /// Loose ends; turns of more than 60 degrees where no third edge meets: where an edge of
        /// the form turns, so do its walls, and there is an edge between these; and facets
        /// between two of the edges, whose third side is bent but none of them.
        std::uint32_t faults = 0;
    };
    std::vector<Net> nets;
};

/// Joins the edges that a style with this crease angle shows to lines, which end where other than
/// two of them meet. The edges must outlive the result.
TracedCreases trace_creases(const ExtractorData& data, const std::vector<CreaseEdge>& edges,
                            float least_angle);

}  // namespace laplacian_lines
