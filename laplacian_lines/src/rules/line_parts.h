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

/// How much is seen of a point, by the mean concavity around it.
float concavity_opacity(const LineRules& rules, float concavity);

/// Points [begin, begin + count) of a line; of a closed one they may go on at its beginning.
struct LinePart {
    std::size_t begin, count;
    bool closed;
    float slope;  ///< the largest mean slope
};

/// Which parts of a whole line are drawn. Slope, gradient and concavity are means over 5.2 √h of
/// the line, about what a Gaussian of 1.5 √h sees; so fine texture, which changes their signs from
/// segment to segment, does not cut a line that is clear on the whole. A part starts where all of
/// them are clear for 1.5 √h, and goes on up to 6 √h to both sides while they are not clearly bad.
/// It ends at hairpins, beyond which a line is its own companion on the convex side.
class LinePartFinder {
public:
    /// Replaces what was found before.
    void find(const LineRules& rules, const LineCourse& line);

    const std::vector<LinePart>& parts() const { return parts_; }
    /// Mean slope and concavity around a point of the line.
    float slope(std::size_t point) const { return means_[point].slope; }
    float concavity(std::size_t point) const { return means_[point].concavity; }

private:
    struct Means {
        float slope, gradient, concavity;
    };
    struct Sums {
        double length, slope, gradient, concave;
    };
    enum class State : unsigned char { Left, Continues, Starts };

    void addUp(const LineCourse& line);
    void average(const LineCourse& line, double reach);
    void judge(const LineRules& rules, const LineCourse& line);
    void cutHairpins(const LineCourse& line, double reach);
    void addParts(std::size_t begin, std::size_t end, double kernel_size);
    double lengthBetween(std::size_t from, std::size_t to) const;

    std::size_t points_ = 0;  ///< of a closed line, without the copy of the first
    std::size_t offset_ = 0;  ///< of the line's first point in sums_
    std::vector<Sums> sums_;  ///< from the first segment on; of closed lines thrice around
    std::vector<Means> means_;
    std::vector<State> states_;
    std::vector<LinePart> parts_;
};

}  // namespace laplacian_lines
