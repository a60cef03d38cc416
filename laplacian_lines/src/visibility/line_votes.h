// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/line_set.h"
#include "laplacian_lines/line_visibility.h"
#include "visibility/line_parts.h"
#include "visibility/sight.h"

namespace laplacian_lines {

/// Lengths that decisions go by, in mesh units.
struct SightLengths {
    double diagonal;  ///< D
    double mean_edge;
    double sight_edge;  ///< as sight_clearance() has it

    double clearance(LineKind kind) const { return sight_clearance(kind, diagonal, sight_edge); }
};

/// A piece of a line in space.
struct PlacedPiece {
    LinePiece piece;
    Eigen::Vector3d middle;
    Eigen::Vector3d across;  ///< to the free side, as long as the piece is in the picture
    Eigen::Vector3d aside;   ///< the same, unit or zero

    double length() const { return piece.length; }
};

/// Votes of rays on the pieces of one line.
class LineVotes {
public:
    /// `side` is that of free_side(); 0 counts as the right one.
    LineVotes(const LineSet& lines, const Polyline& line, int side, const SightLengths& lengths,
              Sight& sight)
        : lines_(lines), line_(line), side_(side), lengths_(lengths), sight_(sight) {}

    /// Pieces of the line, which begin anew at each of `places`.
    std::vector<PlacedPiece> pieces(const std::vector<LinePlace>& places) const;

    Eigen::Vector3d place(const LinePlace& at) const {
        return point_at(lines_, line_, at).position.cast<double>();
    }
    LinePlace middle_place(const LinePiece& piece) const { return middle_of(lines_, line_, piece); }

    /// The share of rays from here that reach the eye.
    double share_seen(const Eigen::Vector3d& p, const Eigen::Vector3d& aside);
    /// Whether there is more surface on this side of a place: inside a form there is.
    bool is_before_surface(const PlacedPiece& piece);
    /// How much the surface at a contour faces its free side, the cosine.
    double facing(const PlacedPiece& piece) const;
    /// 1 where the eye sees the surface beside a contour on the other side only, -1 where it does
    /// on the free side only, else 0.
    int surface_across(const PlacedPiece& piece);

private:
    const LineSet& lines_;
    const Polyline& line_;
    const int side_;
    const SightLengths& lengths_;
    Sight& sight_;
};

/// Runs of equal labels, those of a closed line once around: visit(label, numbers of pieces).
template <class Visit>
void for_each_run(const std::vector<std::uint8_t>& labels, bool closed, Visit visit) {
    const std::size_t n = labels.size();
    std::size_t first = 0;
    while (closed && first + 1 < n && labels[first] == labels[n - 1])
        ++first;
    if (closed && first + 1 == n) first = 0;
    for (std::size_t k = 0; k < n;) {
        std::vector<std::size_t> run;
        const std::uint8_t label = labels[(first + k) % n];
        for (; k < n && labels[(first + k) % n] == label; ++k)
            run.push_back((first + k) % n);
        visit(label, run);
    }
}

}  // namespace laplacian_lines
