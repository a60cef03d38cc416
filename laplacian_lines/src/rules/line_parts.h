// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "rules/line_rules.h"

namespace laplacian_lines {

/// A whole line point by point, in local coordinates; closed: the last point is the first again.
struct LineCourse {
    std::size_t count;
    bool closed;
    const float *x, *y, *z;
    const float* gradient;   ///< ‖∇I‖
    const float* slope;      ///< of the segment that ends at the point; less than 0 at phantoms
    const float* concavity;  ///< cosine between −∇I and the tangential part of l
};

/// Points [begin, begin + count) of a line; of a closed one they may go on at its beginning.
struct LinePart {
    std::size_t begin, count;
    bool closed;
};

/// Which parts of a whole line are drawn, and how much of them is seen. Slope, gradient and
/// concavity are means over 5.2 √h of the line, about what a Gaussian of 1.5 √h sees; so fine
/// texture, which changes their signs from segment to segment, does not cut a line that is clear on
/// the whole. A line starts where all of them are clear, and goes on up to 6 √h to both sides while
/// they are not bad. It ends at hairpins, beyond which it is its own companion on the convex side.
/// All of this comes and goes evenly, as far as LineRules::fading says, so that a line that turns
/// with the view does not jump.
class LinePartFinder {
public:
    /// Replaces what was found before.
    void find(const LineRules& rules, const LineCourse& line);

    const std::vector<LinePart>& parts() const { return parts_; }
    /// Mean slope around a point of the line.
    float slope(std::size_t point) const { return means_[point].slope; }
    float opacity(std::size_t point) const { return seen_[point]; }

private:
    struct Means {
        float slope, gradient, concavity;
    };
    struct Sums {
        double length, slope, gradient, concave;
    };

    void addUp(const LineCourse& line);
    void average(const LineCourse& line, double reach);
    void judge(const LineRules& rules, const LineCourse& line);
    void fadeAtHairpins(const LineCourse& line, double reach);
    void spread(const LineCourse& line, double reach);
    void collectParts(const LineCourse& line);

    std::size_t points_ = 0;  ///< of a closed line, without the copy of the first
    std::size_t offset_ = 0;  ///< of the line's first point in sums_
    std::vector<Sums> sums_;  ///< from the first segment on; of closed lines thrice around
    std::vector<Means> means_;
    std::vector<float> continues_, starts_, seen_;  ///< 0..1, by point
    std::vector<LinePart> parts_;
};

}  // namespace laplacian_lines
