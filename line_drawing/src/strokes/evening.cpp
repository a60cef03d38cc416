// SPDX-License-Identifier: GPL-3.0-or-later
// An edge of the form may be a contour by turns, where what is behind it is farther away, or where
// another one behind it lies on the same line of the picture:
//  1. Each end of an edge or contour gets the end that continues it best, if any.
//  2. What continues each other is one line, and has the class of the greater part of it.
#include <algorithm>
#include <array>
#include <map>

#include "strokes/drawn_lines.h"
#include "strokes/strokes.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double kTangentReach = 2;     // reaches
constexpr double kGoesOnCosine = 0.94;  // of 20°

struct End {
    std::size_t line;
    Vector2d position, outwards;
};

class Evening {
public:
    Evening(std::vector<DrawnLine>& lines, double reach) : lines_(lines), reach_(reach) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const auto& [line_class, closed, points, jump, kind] = lines[i];
            const bool is_one = line_class == LineClass::Contour || line_class == LineClass::Edge;
            if (!is_one || closed || points.size() < 2) continue;
            ends_.push_back({i, points.front().position, outwards(points, false)});
            ends_.push_back({i, points.back().position, outwards(points, true)});
        }
        next_.assign(ends_.size(), kNone);
        pair_ends();
    }

    void run() {
        std::vector<bool> is_done(ends_.size());
        for (const bool is_ring : {false, true})  // open ones first, from an end
            for (std::size_t e = 0; e < ends_.size(); ++e) {
                if (is_done[e] || (!is_ring && next_[e] != kNone)) continue;
                std::vector<std::size_t> parts;
                for (std::size_t at = e; at != kNone && !is_done[at]; at = next_[at ^ 1]) {
                    is_done[at] = is_done[at ^ 1] = true;
                    parts.push_back(ends_[at].line);
                }
                even_out(parts);
            }
    }

private:
    static constexpr std::size_t kNone = std::size_t(-1);

    Vector2d outwards(const std::vector<DrawnPoint>& points, bool is_last) const {
        return outwards_at(points, is_last, kTangentReach * reach_);
    }

    void pair_ends() {
        using Pair = std::array<std::size_t, 2>;
        std::vector<std::pair<double, Pair>> pairs;  // by their turn
        std::map<std::array<std::int64_t, 2>, std::vector<std::size_t>> cells;
        for (std::size_t e = 0; e < ends_.size(); ++e) {
            const Vector2d at = (ends_[e].position / reach_).array().floor();
            const auto x = std::int64_t(at.x()), y = std::int64_t(at.y());
            for (std::int64_t i = x - 1; i <= x + 1; ++i)
                for (std::int64_t k = y - 1; k <= y + 1; ++k)
                    for (const std::size_t other : cells[{i, k}]) {
                        const double turn = ends_[e].outwards.dot(ends_[other].outwards);
                        if (turn < -kGoesOnCosine && ends_[e].line != ends_[other].line &&
                            (ends_[e].position - ends_[other].position).norm() < reach_)
                            pairs.push_back({turn, {other, e}});
                    }
            cells[{x, y}].push_back(e);
        }
        std::sort(pairs.begin(), pairs.end());
        for (const auto& [turn, ends] : pairs)
            if (next_[ends[0]] == kNone && next_[ends[1]] == kNone) {
                next_[ends[0]] = ends[1];
                next_[ends[1]] = ends[0];
            }
    }

    void even_out(const std::vector<std::size_t>& parts) {
        double edges = 0, contours = 0;
        for (const std::size_t i : parts)
            (lines_[i].line_class == LineClass::Edge ? edges : contours) +=
                length_of(lines_[i].points);
        if (edges == 0 || contours == 0) return;
        for (const std::size_t i : parts)
            lines_[i].line_class = edges > contours ? LineClass::Edge : LineClass::Contour;
    }

    std::vector<DrawnLine>& lines_;
    const double reach_;
    std::vector<End> ends_;          // the first and the last of each line
    std::vector<std::size_t> next_;  // by end
};

}  // namespace

void even_out_classes(std::vector<DrawnLine>& lines, double reach) {
    Evening(lines, reach).run();
}

}  // namespace line_drawing
