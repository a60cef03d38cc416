// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "extractor_data.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/line_style.h"

namespace laplacian_lines {

/// A homogeneous point in local coordinates, scaled so that n·(eye − w p) is about in [−1, 1].
struct LocalEye {
    Eigen::Vector3f eye;
    float w;

    Eigen::Vector3f towards(const Eigen::Vector3f& p) const { return eye - w * p; }
};

/// Where the eye and the light are; mostly the same.
struct LocalView {
    LocalEye eye, light;
    bool light_at_eye = true;
};

/// What decides which zero crossings of a per-vertex function become lines, one for each kind.
/// Without more ado, everything is kept and nothing fades.
struct LineRules {
    static constexpr float kAnything = std::numeric_limits<float>::lowest();

    LineKind kind = LineKind::Laplacian;
    float least_gradient = kAnything;  ///< ‖∇I‖·D
    float least_facing = kAnything;    ///< n·l/|l|
    bool reject_phantoms = false;
    bool concave_only = false;
    bool use_slope = false;  ///< false: no slopes are computed or tested, lines have full width
    float segment_slope = 0, line_slope = 0, full_slope = 1;
    float least_strength = kAnything;
    float least_length = kAnything;  ///< D
    float fading = 0;                ///< full opacity at (1 + fading) times a threshold
    int smoothing_passes = 0;        ///< of the positions, each with the weights 1-2-1
    float end_length = 0;            ///< over which open ends fade, D
    float contour_clearance = 0;     ///< lines nearer to a contour fade out, D in the picture
};

LineRules laplacian_rules(const LineStyle& style);
LineRules contour_rules(const LineStyle& style);

/// How many passes of smooth_line() have this standard deviation.
int smoothing_passes(double deviation);

/// The functions whose zeros are lines, at a vertex; together, since both are read near lines.
struct VertexValue {
    float laplacian;  ///< ΔI
    float facing;     ///< n·(eye − w p), zero on contours; I itself with the light at the eye
};
using LineFunction = float VertexValue::*;

struct VertexValues {
    std::vector<VertexValue> values;
    std::vector<std::uint8_t> signs;  ///< bits of SignBit
};

enum SignBit : std::uint8_t { kNegativeLaplacian = 1, kNegativeFacing = 2, kFacesAway = 4 };

void evaluate_vertices(const ExtractorData& data, const LocalView& view, const LineStyle& style,
                       VertexValues& values);

/// A triangle whose corners do not all have the same sign, with its corners, so that they need not
/// be fetched again.
struct MixedTriangle {
    std::uint32_t index;
    Triangle corners;
};

struct MixedTriangles {
    std::vector<MixedTriangle> laplacian;  ///< of ΔI, not counting those that face away
    std::vector<MixedTriangle> contour;    ///< of the facing
};

void find_mixed_triangles(const ExtractorData& data, const VertexValues& values,
                          MixedTriangles& mixed);

/// A zero on an edge of the mesh.
struct Crossing {
    Eigen::Vector3f position;  ///< local
    float gradient;            ///< ‖∇I‖
    float opacity;             ///< less than 1 where the crossing alone asks for fading
    std::uint32_t edge;
    bool accepted;  ///< passes the tests that look at the crossing alone
};

/// The piece of a line in one triangle, from one crossing to another. On consistently oriented
/// triangles the end of one is the begin of the next.
struct Segment {
    std::uint32_t begin, end;  ///< crossings
    float slope;
};

/// Crossings are found once an edge through `crossing_of_edge`, which is kNoCrossing everywhere
/// between uses.
struct CrossingGraph {
    static constexpr std::uint32_t kNoCrossing = 0xffffffffu;
    std::vector<Crossing> crossings;
    std::vector<Segment> segments;
    std::vector<std::uint32_t> crossing_of_edge;
    bool in_use = false;  ///< an exception left crossing_of_edge behind
};

/// Replaces the graph by the segments in the given triangles that pass the rules of single
/// crossings and segments. `function` is the one whose zeros are looked for.
void find_segments(const ExtractorData& data, const LocalView& view, const LineRules& rules,
                   const VertexValues& values, LineFunction function,
                   const std::vector<MixedTriangle>& triangles, CrossingGraph& graph);

}  // namespace laplacian_lines
