// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace laplacian_lines {

enum class LineKind : std::uint32_t;

/// What decides which zero crossings become lines, one per kind. By default everything is kept and
/// nothing fades.
struct LineRules {
    static constexpr float kAnything = std::numeric_limits<float>::lowest();

    LineKind kind{};
    float least_gradient = kAnything;  ///< ‖∇I‖·D
    float least_facing = kAnything;    ///< n·v/|v|
    bool reject_phantoms = false;
    bool concave_only = false;
    /// Skip triangles with is_convex() at all corners, where concave_only would accept hardly any
    /// crossing. For whole lines that nothing convex should cut, the corners' neighbours count as
    /// well.
    bool leave_out_convex = false;
    /// Skip triangles without a form of their own, see find_featureless_triangles().
    bool drop_featureless = false;
    /// Skip triangles with n·v < 0 at all corners, where other rules leave nothing.
    bool leave_out_away = false;
    bool use_slope = false;  ///< false: no slopes are computed or tested, nor decide the width
    float slope_scale = 0;   ///< h_e^1.5, D³: slopes have no unit
    float segment_slope = 0, line_slope = 0, full_slope = 1;
    float least_strength = kAnything;
    float least_length = kAnything;  ///< D
    /// Lines thin out where the surface is concave along the view, up to this cosine between the
    /// view vector v and −∇(n·v) = −Sv. The surface before them hides contours there, but only
    /// just, so that part of a wide stroke would show. Not on surfaces seen from both sides.
    float concave_thinning = kNoThinning;
    static constexpr float kNoThinning = std::numeric_limits<float>::max();
    static constexpr float kFlat = 0.1f;  ///< ‖∇I‖·D; where it is less, signs are those of noise
    float fading = 0;                     ///< full opacity at (1 + fading) times a threshold
    /// Test means along lines instead of crossings and segments, see line_parts.h.
    bool whole = false;
    float kernel_size = 0;              ///< √h, D: means are over lengths of this order
    float least_concavity = kAnything;  ///< cosine, of crossings of whole lines
    int smoothing_passes = 0;           ///< of the positions, each with the weights 1-2-1
    float end_length = 0;               ///< over which open ends fade, D
    float contour_clearance = 0;        ///< lines nearer to a contour fade out, D in the picture
};

/// Whether triangles are left out for their own convexity, not for that of all around them.
static inline bool is_cut_by_convex(const LineRules& rules) {
    return !rules.whole || !rules.concave_only || rules.least_concavity > -1;
}

/// Passes with the weights 1-2-1 for a standard deviation in points of a line.
int smoothing_passes(double deviation);

}  // namespace laplacian_lines
