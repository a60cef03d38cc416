// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// Nearer than this, in reaches of what doubles a line, nothing white is left beside it.
constexpr double beside_reach = 1.4;
/// In reaches: what is so near a line is at one place with it.
constexpr double same_reach = 0.1;
/// Cosine of the least turn by which a line runs back along itself: 120°.
constexpr double reversal = -0.5;

/// Lines on paper that are there already, to be asked whether another one would only double them.
/// Millimetres.
class DrawnLines {
public:
    /// Lines nearer than `reach` that run along one are doubles of it.
    explicit DrawnLines(double reach) : reach_(reach) {}

    /// `number` tells lines apart.
    void add(const std::vector<Eigen::Vector2d>& line, std::size_t number = 0);

    /// How far `point` is from a line that runs along the unit direction `way`, within 20°; the
    /// reach if none is nearer.
    double distanceAlong(const Eigen::Vector2d& point, const Eigen::Vector2d& way) const;

    /// Whether `point` is within this distance beside a line, whichever way that runs, not beyond
    /// its end.
    bool isBeside(const Eigen::Vector2d& point, double within) const;

    /// Of lines: that one, or from a first to a last one.
    struct Numbers {
        Numbers(std::size_t one) : first(one), last(one) {}
        Numbers(std::size_t from, std::size_t to) : first(from), last(to) {}
        std::size_t first, last;
    };
    /// The nearest place on another line than those of some numbers, within the distance, and the
    /// number of that line.
    struct Place {
        Eigen::Vector2d position;
        std::size_t line;
    };
    std::optional<Place> nearestOn(const Eigen::Vector2d& point, const Numbers& except,
                                   double within) const;

    /// The nearest line beside `point` on one side, where the unit vector `side` points, within
    /// 20°, and the line runs across that; none of those that `skips` names.
    struct Neighbour {
        Eigen::Vector2d position, way;  ///< unit
        std::size_t line;
    };
    struct Distances {
        double least, most;
    };
    std::optional<Neighbour> nextOn(
        const Eigen::Vector2d& point, const Eigen::Vector2d& side, const Distances& distances,
        const std::function<bool(std::size_t)>& skips = [](std::size_t) { return false; }) const;

private:
    struct Piece {
        Eigen::Vector2d begin, end;
        std::size_t line;
    };
    using Cell = std::uint64_t;

    std::int64_t squareOf(double coordinate) const;
    static Cell cell(std::int64_t x, std::int64_t y);
    template <class Visit>
    void forEachPieceNear(const Eigen::Vector2d& point, double within, Visit visit) const;

    const double reach_;
    std::unordered_map<Cell, std::vector<Piece>> pieces_;  // in squares of twice the reach
};

/// Of all lines, by their numbers.
DrawnLines allOf(const std::vector<DrawnLine>& lines, double reach);

}  // namespace line_drawing
