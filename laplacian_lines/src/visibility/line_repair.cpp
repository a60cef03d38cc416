// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/chains.h"
#include "visibility/visibility_pieces.h"

namespace laplacian_lines {
namespace {

constexpr double kShortestGap = 0.001, kShortestPart = 0.003;  // in D of the line's own surface

/// Diagonal of the surface that a line is on, local.
double own_diagonal(const VisibilitySegments& all, const VisibilitySegments::Line& of) {
    double sum = 0;
    for (std::uint32_t i = 1; i < of.line->count; ++i)
        sum += (all.position(of.first_point + i) - all.position(of.first_point + i - 1)).norm();
    return of.line->length > 0 ? sum / double(of.line->length) : 0;
}

double length_of(const VisibilitySegments& all, const VisibilityPiece& piece) {
    const VisibilitySegment& segment = all.segments[piece.segment];
    return (share_at(all, piece, 1) - share_at(all, piece, 0)) *
           (all.position(segment.points[1]) - all.position(segment.points[0])).norm();
}

/// Makes runs of hidden pieces of a line that are shorter than `shortest`, local, visible, or the
/// other way round.
void flip_short_runs(const VisibilitySegments& all, bool hidden, double shortest,
                     VisibilityPiece* pieces, std::size_t count) {
    const bool is_closed = pieces[0].nodes[0] == pieces[count - 1].nodes[1];
    const auto is_in = [&](std::size_t i) { return pieces[i].is_hidden == hidden; };
    for_each_run(count, is_closed, is_in, [&](std::size_t begin, std::size_t n) {
        double sum = 0;
        for (std::size_t i = begin; i < begin + n; ++i)
            sum += length_of(all, pieces[i % count]);
        // a gap at an open end is none
        const bool is_between = is_closed || (begin > 0 && begin + n < count) || !hidden;
        if (n == count || !is_between || sum >= shortest) return;
        for (std::size_t i = begin; i < begin + n; ++i)
            pieces[i % count].is_hidden = !hidden;
    });
}

}  // namespace

void repair_lines(const VisibilitySegments& all, std::vector<VisibilityPiece>& pieces) {
    const auto line_of = [&](std::size_t i) { return all.segments[pieces[i].segment].line; };
    for (std::size_t begin = 0, end; begin < pieces.size(); begin = end) {
        end = begin + 1;
        if (line_of(begin) == VisibilitySegment::kNone) continue;
        while (end < pieces.size() && line_of(end) == line_of(begin) &&
               pieces[end].nodes[0] == pieces[end - 1].nodes[1])
            ++end;
        const double diagonal = own_diagonal(all, all.lines[line_of(begin)]);
        flip_short_runs(all, true, kShortestGap * diagonal, &pieces[begin], end - begin);
        flip_short_runs(all, false, kShortestPart * diagonal, &pieces[begin], end - begin);
    }
}

}  // namespace laplacian_lines
