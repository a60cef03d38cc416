// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

namespace line_renderer {

/// Values that a segment interpolates on the screen.
enum SeenValue { SeenDepth, SeenRadius, SeenOpacity, kSeenValueCount };
using SeenValues = std::array<float, kSeenValueCount>;

struct SeenPoint {
    Eigen::Vector2f pixel = Eigen::Vector2f::Zero();
    SeenValues values{};
    SeenValues tolerance{};  ///< by how much the picture's values may differ from them
    bool is_before_near_plane = false;
};

/// Simplifies lines: successive points that one straight segment can replace, found in one pass.
///
/// For each dropped point p_i, the segment has a point q_i at most `tolerance` pixels away, with
/// values within p_i's own tolerances, in the same order. With s_i the greatest distance from the
/// start up to p_i, and s that up to the end, q_i is at s_i / s of the segment. This is ensured by
/// distances that hardly fall, directions within a cone (J. Sklansky, V. Gonzalez, "Fast polygonal
/// approximation of digitized curves", 1980) and slopes within an interval (H. Elmeleegy et al.,
/// "Online piece-wise linear approximation of numerical streams with precision guarantees", 2009).
class StraightPiece {
public:
    /// In pixels.
    explicit StraightPiece(float tolerance);

    void begin(const SeenPoint& start);
    /// Adds the point if a segment to it can replace all points since begin(), and returns whether.
    /// Always true for the first point, else never with one behind the near plane among them.
    bool try_extend(const SeenPoint& point);

private:
    using Vector = Eigen::Vector2f;

    bool can_end(const SeenPoint& point, const Vector& offset, float distance) const;
    void narrow_directions(const Vector& offset, float distance);
    void narrow_slopes(const SeenPoint& point);

    const float aside_;     ///< pixels beside the segment
    const float backward_;  ///< pixels by which the distance from the start may fall

    SeenPoint start_;
    bool is_empty_ = true;
    bool is_open_ = true;
    float reach_ = 0;  ///< greatest distance from the start so far, pixels, at least kLeastReach
    bool has_cone_ = false;
    Vector right_, left_;  ///< directions between which all further points have to be
    SeenValues least_slope_, greatest_slope_;  ///< per pixel of reach
};

}  // namespace line_renderer
