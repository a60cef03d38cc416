// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <unordered_map>
#include <vector>

#include "drawn_view.h"

namespace line_drawing {

/// Lines on paper that are there already, to be asked whether another one would only double them.
/// Millimetres.
class DrawnLines {
public:
    /// Lines nearer than `reach` that run along one are doubles of it.
    explicit DrawnLines(double reach) : reach_(reach) {}

    void add(const std::vector<Eigen::Vector2d>& line);

    /// How far `point` is from a line that runs along the unit direction `way`, within 20°; the
    /// reach if none is nearer.
    double distanceAlong(const Eigen::Vector2d& point, const Eigen::Vector2d& way) const;

    /// Whether `point` is within this distance, 1.4 reaches at most, beside a line, whichever way
    /// that runs, not beyond its end.
    bool isBeside(const Eigen::Vector2d& point, double within) const;

    /// Whether a line is short, ends within the reach of others and is beside them nearly all
    /// along.
    bool addsNothing(const DrawnLine& line) const;

private:
    struct Piece {
        Eigen::Vector2d begin, end;
    };
    using Cell = std::uint64_t;

    Cell cellOf(double x, double y) const;
    template <class Visit>
    void forEachPieceNear(const Eigen::Vector2d& point, Visit visit) const;

    const double reach_;
    std::unordered_map<Cell, std::vector<Piece>> pieces_;  // in squares of twice the reach
};

/// Lines, in the sheet's coordinates, without the parts that only double others: of lower classes
/// those along higher ones (sections first), among one class along longer ones; without short lines
/// that are beside others nearly all along, and jogs. Sorted by class and length.
std::vector<DrawnLine> withoutDoubles(std::vector<DrawnLine> lines, double reach);

}  // namespace line_drawing
