// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "laplacian_lines/line_kind.h"

namespace laplacian_lines {

/// A point of a line; plain floats in this order, so that an array of them can be uploaded as is.
struct LinePoint {
    Eigen::Vector3f position;  ///< mesh coordinates, less the set's origin
    float weight;              ///< 0..1, share of the full line width
    /// ‖∇I‖·D; of contours and suggestive ones for the light at the eye, 0 where contours follow
    /// edges, −0 at both ends of a hollow edge seen from outside, which its own surface hides; of
    /// apparent ridges q1·D; of ridges, valleys, creases and demarcating curves the angle by which
    /// the surface turns, degrees; of borders 0.
    float gradient;
    float opacity;  ///< 0..1; lines that are about to vanish are nearly transparent
};

/// A traced line: points[first .. first+count) of its LineSet. A closed one repeats its first
/// point.
struct Polyline {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    LineKind kind = LineKind::Laplacian;
    bool closed = false;
    float strength = 0;  ///< Eq. 4, dimensionless; 0 of lines that do not depend on the view
    float length = 0;    ///< in D
    float slope = 0;     ///< mean, dimensionless; 0 where strength is, and of contours; -1 of
                         ///< creases that face away
};

struct LineSet {
    std::vector<LinePoint> points;
    std::vector<Polyline> lines;
    /// Mesh coordinates. Zero unless the mesh is so far from zero that floats would be coarse
    /// there.
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();

    void clear() {
        points.clear();
        lines.clear();
    }
    /// Mesh coordinates.
    Eigen::Vector3d position(const LinePoint& point) const {
        return origin + point.position.cast<double>();
    }
    /// Of all lines.
    std::size_t segment_count() const { return points.size() - lines.size(); }
};

}  // namespace laplacian_lines
