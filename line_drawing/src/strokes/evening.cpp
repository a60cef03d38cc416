// SPDX-License-Identifier: GPL-3.0-or-later
// An edge of the form may be a contour by turns, where what is behind it is farther away, or where
// another one behind it lies on the same line of the picture:
//  1. Each end of an edge or contour gets the end that continues it best, if any.
//  2. What continues each other is one line, and has the class of the greater part of it.
#include <algorithm>

#include "strokes/drawn_lines.h"
#include "strokes/end_pairs.h"
#include "strokes/strokes.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double kTangentReach = 2;  // reaches

void even_out(const std::vector<DrawnLine*>& parts) {
    double edges = 0, contours = 0, jump = 0;
    for (const DrawnLine* line : parts) {
        (line->line_class == LineClass::Edge ? edges : contours) += length_of(line->points);
        jump = std::max(jump, line->jump);
    }
    if (edges == 0 || contours == 0) return;
    for (DrawnLine* line : parts) {
        line->line_class = edges > contours ? LineClass::Edge : LineClass::Contour;
        line->jump = jump;
    }
}

}  // namespace

void even_out_classes(std::vector<DrawnLine>& lines, double reach) {
    std::vector<DrawnLine*> at;  // by end
    std::vector<Vector2d> positions, outwards;
    for (DrawnLine& line : lines) {
        const bool is_one =
            line.line_class == LineClass::Contour || line.line_class == LineClass::Edge;
        if (!is_one || line.closed || line.points.size() < 2) continue;
        for (const bool is_last : {false, true}) {
            at.push_back(&line);
            positions.push_back((is_last ? line.points.back() : line.points.front()).position);
            outwards.push_back(outwards_at(line.points, is_last, kTangentReach * reach));
        }
    }
    const auto turn = [&](std::size_t a, std::size_t b) -> std::optional<double> {
        const double cosine = outwards[a].dot(outwards[b]);
        if (cosine > -kAlongCosine || at[a] == at[b] ||
            (positions[a] - positions[b]).norm() > reach)
            return {};
        return cosine;
    };
    for_each_chain_of_ends(pair_ends(positions, reach, turn),
                           [&](const std::vector<std::size_t>& way, bool) {
                               std::vector<DrawnLine*> parts;
                               for (const std::size_t e : way)
                                   parts.push_back(at[e]);
                               even_out(parts);
                           });
}

}  // namespace line_drawing
