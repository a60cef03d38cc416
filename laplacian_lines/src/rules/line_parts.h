// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "rules/line_rules.h"

namespace laplacian_lines {

/// A piece of a whole line: its length in D, and sums of values times length along it.
struct LinePiece {
    float length;
    float slope;     ///< of the slope, less than 0 at phantoms
    float gradient;  ///< of ‖∇I‖
    float concave;  ///< of ‖∇I‖ times the cosine between −∇I and the tangential part of l
};

/// Pieces [begin, begin + count) of a line; of a closed one they may go on at its beginning.
struct LinePart {
    std::size_t begin, count;
    bool closed;
};

/// Which parts of a whole line are drawn, and how much of them is seen. Slope, gradient and
/// concavity are means over 5.2 √h of the line, about what a Gaussian of 1.5 √h sees; so fine
/// texture, which changes their signs from segment to segment, does not cut a line that is clear on
/// the whole. A line starts where all of them are clear, and goes on up to 6 √h to both sides while
/// they are not bad. All of this comes and goes evenly, as far as LineRules::fading says, so that a
/// line that turns with the view does not jump.
///
/// Pieces are up to some √h long. Knots are where they meet, one more than there are pieces; what
/// is found is found there, and goes evenly from one knot to the next.
class LinePartFinder {
public:
    /// Replaces what was found before. Of a closed line, the last knot is the first again.
    void find(const LineRules& rules, const std::vector<LinePiece>& pieces, bool closed);

    const std::vector<LinePart>& parts() const { return parts_; }
    /// Mean slope around a knot.
    float slope(std::size_t knot) const { return means_[knot].slope; }
    /// How much is seen of the line, and how clear it is by itself: 0..1.
    float opacity(std::size_t knot) const { return seen_[knot]; }
    float start(std::size_t knot) const { return starts_[knot]; }

private:
    struct Means {
        float slope, gradient, concavity;
    };
    struct Sums {
        double length, slope, gradient, concave;
    };

    void addUp(const std::vector<LinePiece>& pieces);
    void average(double reach);
    void judge(const LineRules& rules);
    void spread(double reach);
    void collectParts();

    std::size_t pieces_ = 0;
    bool closed_ = false;
    std::size_t offset_ = 0;  ///< of the line's first knot in sums_
    std::vector<Sums> sums_;  ///< from the first piece on; of closed lines thrice around
    std::vector<Means> means_;
    std::vector<float> continues_, starts_, seen_;  ///< 0..1, by knot
    std::vector<LinePart> parts_;
};

}  // namespace laplacian_lines
