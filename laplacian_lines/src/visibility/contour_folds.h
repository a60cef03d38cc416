// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "visibility/line_votes.h"

namespace laplacian_lines {

/// Where a contour, between two cusps, runs behind its own form: the surface there faces the other
/// side.
struct ContourFolds {
    std::vector<std::uint8_t> bends_in;  ///< by piece
    /// Runs of pieces, too short to be sure of, that may be such folds.
    std::vector<std::vector<std::size_t>> possible;
};

ContourFolds find_folds(const std::vector<PlacedPiece>& pieces, bool closed,
                        const SightLengths& lengths, LineVotes& votes);

}  // namespace laplacian_lines
