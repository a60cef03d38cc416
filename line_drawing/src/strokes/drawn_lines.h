// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "views/drawn_view.h"

namespace line_drawing {

/// In reaches: nearer than this leaves no white between lines.
constexpr double kBesideReach = 1.4;
/// In reaches: nearer than this is the same place.
constexpr double kSameReach = 0.1;
/// Cosine of the largest angle between lines that run along each other: 20°.
constexpr double kAlongCosine = 0.94;
/// Cosine of the least turn at which a line doubles back: 120°.
constexpr double kReversal = -0.5;

/// Lines already on the paper, to ask whether another would double them. Millimetres.
class DrawnLines {
public:
    static constexpr std::size_t kNoLine = std::size_t(-1);

    /// `reach`: about as far as queries go; the larger, the more lines each of them looks at.
    explicit DrawnLines(double reach) : reach_(reach) {}

    void add(const std::vector<Eigen::Vector2d>& line, std::size_t number = 0);

    /// Whether a line this near runs along the unit direction `way`, within 20°, and the point is
    /// beyond its ends by no more than `beyond`.
    bool run_along(const Eigen::Vector2d& point, const Eigen::Vector2d& way, double within,
                   double beyond = INFINITY) const;

    /// Whether `point` is this near beside a line in any direction, not beyond its end.
    bool is_beside(const Eigen::Vector2d& point, double within) const;

    /// Whether any line but `except` is this near.
    bool is_near(const Eigen::Vector2d& point, std::size_t except, double within) const;
    /// The nearest place on any line but `except`, if one is this near.
    struct Place {
        Eigen::Vector2d position;
        std::size_t line;
    };
    std::optional<Place> nearest_on(const Eigen::Vector2d& point, std::size_t except,
                                    double within) const;

    /// The nearest line in the direction of the unit vector `side`, within 20°, that runs across
    /// that; not those for which skips(line) is true.
    struct Neighbour {
        Eigen::Vector2d position, way;  ///< unit
        std::size_t line;
    };
    struct Distances {
        double least, most;
    };
    std::optional<Neighbour> next_on(
        const Eigen::Vector2d& point, const Eigen::Vector2d& side, const Distances& distances,
        const std::function<bool(std::size_t)>& skips = [](std::size_t) { return false; }) const;

private:
    struct Piece {
        Eigen::Vector2d begin, end;
        std::size_t line;

        /// Whether a point is before its begin or beyond its end by more than that.
        bool is_passed(const Eigen::Vector2d& point, double by) const;
    };
    using Cell = std::uint64_t;

    std::int64_t square_of(double coordinate) const;
    static Cell cell(std::int64_t x, std::int64_t y);
    /// Of pieces with a place in the box, until test(piece) is true; whether it was.
    template <class Test>
    bool any_piece_in(const Eigen::AlignedBox2d& box, Test test) const;
    template <class Test>
    bool any_piece_near(const Eigen::Vector2d& point, double within, Test test) const;

    double reach_;
    std::unordered_map<Cell, std::vector<Piece>> pieces_;  // by the square of their middle
};

/// On a sheet, whose y points down.
inline Eigen::Vector2d right_of(const Eigen::Vector2d& way) {
    return {-way.y(), way.x()};
}

bool is_curved_contour(const DrawnLine& line);

/// Whether a line shows the form of a curved surface: an inner line, or a contour.
bool is_on_curved(const DrawnLine& line);

DrawnLines all_of(const std::vector<DrawnLine>& lines, double reach);

/// The share of a line that has others on both sides, no farther away than `within`; `number`: its
/// own among `lines`.
double share_between(const DrawnLine& line, std::size_t number, const DrawnLines& lines,
                     double within);

/// Calls keep(number) once for each line, to return whether the line is drawn whole. Lines come in
/// their order, from the largest of `strengths` down, but a drawn line is followed by its nearest
/// neighbour to each side beyond `white`, mm between middles, that is nearly as long and at least
/// three quarters as strong as the first: so every second or third of close folds is drawn.
void for_each_by_families(const std::vector<DrawnLine>& lines, const std::vector<double>& strengths,
                          double white, const std::function<bool(std::size_t)>& keep);

/// Whether a line runs between two of three evenly spaced folds, at most four √h apart, that go on
/// side by side beyond its ends, for a third of its length, with nothing between them. `kept`:
/// drawn lines; `pen` of inner lines, mm.
bool is_between_folds(const DrawnLine& line, const DrawnLines& kept, double pen);

}  // namespace line_drawing
