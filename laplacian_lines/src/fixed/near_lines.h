// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "laplacian_lines/line_set.h"

namespace laplacian_lines {

/// Which points have lines of a set nearby, for lines that would double others. Time and memory are
/// proportional to the lines' length over the distance. Thread-safe.
class NearLines {
public:
    /// `distance` is in the points' unit; nothing is near unless it is positive.
    NearLines(const LineSet& lines, float distance);

    /// Whether a line passes within the distance of p at less than 45 degrees to `direction`, or
    /// anyhow if that is zero.
    bool any_along(const Eigen::Vector3f& p, const Eigen::Vector3f& direction) const;

private:
    struct Piece {
        Eigen::Vector3f begin, end;
        std::uint32_t next;  ///< of the same cell
    };
    using Cell = Eigen::Matrix<std::int32_t, 3, 1>;

    void add(const Eigen::Vector3f& begin, const Eigen::Vector3f& end);
    bool is_along(const Piece& piece, const Eigen::Vector3f& p,
                  const Eigen::Vector3f& direction) const;

    float distance_;
    std::vector<Piece> pieces_;
    std::unordered_map<std::uint64_t, std::uint32_t> first_of_cell_;
};

/// For each point of `lines`, 1 where a line of `others` runs along within the distance. Any number
/// of threads gives the same.
std::vector<std::uint8_t> points_along(const LineSet& lines, const NearLines& others);

}  // namespace laplacian_lines
