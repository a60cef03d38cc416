// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "rules/line_rules.h"

namespace laplacian_lines {

/// A piece of a line: its length in D, and sums of values times length along it.
struct LinePiece {
    float length;
    float slope;     ///< of the slope, which is less than 0 at phantoms
    float gradient;  ///< of ‖∇I‖
    float concave;  ///< of ‖∇I‖ times the cosine between −∇I and the tangential part of l
};

/// Pieces [begin, begin + count) of a line; of a closed one they may go on at its beginning.
struct LinePart {
    std::size_t begin, count;
    bool closed;
};

/// Which parts of a whole line are drawn, and how visibly, by the means of slope, gradient and
/// concavity over 1.5 √h to both sides (2 unless is_cut_by_convex()): fading is above the least
/// slope, below the least gradient and around a concavity of 0. So texture finer than the kernel,
/// which flips signs from segment to segment, does not cut a clear line, and a line that joins
/// another when the view turns stays as it was but for some √h. Pieces are up to some √h long;
/// knots are where they meet, one more than pieces. Results are at knots, linear between them.
class LinePartFinder {
public:
    /// For a closed line, the last knot is the first again.
    void find(const LineRules& rules, const std::vector<LinePiece>& pieces, bool closed);

    const std::vector<LinePart>& parts() const { return parts_; }
    float slope(std::size_t knot) const { return slopes_[knot]; }
    /// 0..1.
    float opacity(std::size_t knot) const { return seen_[knot]; }

private:
    struct Sums {
        double length, slope, gradient, concave;
    };

    void add_up(const std::vector<LinePiece>& pieces);
    /// At a length along the line; `k`, the next of sums_, only rises from call to call.
    Sums sums_at(double length, std::size_t& k) const;
    void judge(const LineRules& rules, double reach);
    void collect_parts();

    std::size_t pieces_ = 0;
    bool closed_ = false;
    std::size_t offset_ = 0;            ///< of the line's first knot in sums_
    std::vector<Sums> sums_;            ///< from the first piece on; of closed lines thrice around
    std::vector<float> slopes_, seen_;  ///< by knot
    std::vector<LinePart> parts_;
};

}  // namespace laplacian_lines
