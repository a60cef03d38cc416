// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/line_smoothing.h"
#include "rules/line_rules.h"
#include "rules/runs.h"
#include "visibility/sight_pieces.h"

namespace laplacian_lines {
namespace {

constexpr double kShortestGap = 0.001, kShortestPart = 0.003;  // in D of the line's own surface

/// Successive pieces of one line, or of a part that is before the eye.
struct LinePieces {
    const SightPiece* begin;
    const SightPiece* end;
    std::uint32_t first_node;  // of the line's first point
    bool is_whole;
};

class SurfaceLineTracer {
public:
    SurfaceLineTracer(const SightSegments& all, const LineSet& lines, const Polyline& line,
                      const LinePieces& pieces, int smoothing_passes)
        : all_(all),
          lines_(lines),
          line_(line),
          pieces_(pieces),
          passes_(smoothing_passes),
          first_crossing_(first_crossing_node(all)),
          closed_(line.closed && pieces.is_whole) {}

    void trace(std::vector<SightLine>& traced) const {
        std::vector<bool> is_seen;
        for (const SightPiece* piece = pieces_.begin; piece != pieces_.end; ++piece)
            is_seen.push_back(!piece->is_hidden);
        const double diagonal = own_diagonal();
        turn_short_runs(false, kShortestGap * diagonal, is_seen);
        turn_short_runs(true, kShortestPart * diagonal, is_seen);
        for_each_run(
            is_seen.size(), closed_, [&](std::size_t i) { return is_seen[i]; },
            [&](std::size_t begin, std::size_t count) {
                traced.push_back(part(begin, begin + count, closed_ && count == is_seen.size()));
            });
    }

private:
    const SightPiece& piece(std::size_t i) const {
        return pieces_.begin[i % std::size_t(pieces_.end - pieces_.begin)];
    }

    std::uint32_t place_of(const SightPiece& piece) const {
        return all_.segments[piece.segment].points[0] - pieces_.first_node;
    }

    /// Of a piece's end along its segment, in space.
    double share(const SightPiece& piece, int end) const {
        const SightSegment& segment = all_.segments[piece.segment];
        return all_.picture.share_in_space(all_.place(segment.points[0]),
                                           all_.place(segment.points[1]), piece.shares[end]);
    }

    double length(const SightPiece& piece) const {
        const SightSegment& segment = all_.segments[piece.segment];
        return (share(piece, 1) - share(piece, 0)) *
               (all_.position(segment.points[1]) - all_.position(segment.points[0])).norm();
    }

    /// Of the surface that the line is on, local: lengths of lines are in D.
    double own_diagonal() const {
        double sum = 0;
        for (std::uint32_t node = pieces_.first_node + 1; node < pieces_.first_node + line_.count;
             ++node)
            sum += (all_.position(node) - all_.position(node - 1)).norm();
        return line_.length > 0 ? sum / double(line_.length) : 0;
    }

    /// Turns runs of `value` between others that are shorter than `shortest`, local.
    void turn_short_runs(bool value, double shortest, std::vector<bool>& values) const {
        const std::size_t n = values.size();
        const auto is_in = [&](std::size_t i) { return values[i] == value; };
        for_each_run(n, closed_, is_in, [&](std::size_t begin, std::size_t count) {
            double sum = 0;
            for (std::size_t i = begin; i < begin + count; ++i)
                sum += length(piece(i));
            // a gap at an open end is none
            const bool is_between = closed_ || (begin > 0 && begin + count < n) || value;
            if (count == n || !is_between || sum >= shortest) return;
            for (std::size_t i = begin; i < begin + count; ++i)
                values[i % n] = !value;
        });
    }

    LinePoint point_at(const SightPiece& piece, int end) const {
        const LinePoint& a = lines_.points[line_.first + place_of(piece)];
        const LinePoint& b = lines_.points[line_.first + place_of(piece) + 1];
        const auto t = float(share(piece, end));
        const float rest = 1 - t;  // so that lines end exactly at their points
        return {rest * a.position + t * b.position, rest * a.weight + t * b.weight,
                rest * a.gradient + t * b.gradient, rest * a.opacity + t * b.opacity};
    }

    SightLine part(std::size_t begin, std::size_t end, bool closed) const {
        std::vector<LinePoint> points = {point_at(piece(begin), 0)};
        for (std::size_t i = begin; i < end; ++i)
            if (i + 1 == end || piece(i).nodes[1] < first_crossing_)
                points.push_back(point_at(piece(i), 1));
        if (points.size() > 2) {
            Polyline whole;
            whole.count = std::uint32_t(points.size());
            whole.closed = closed;
            smooth_positions(whole, points.data(), passes_);
        }
        SightLine result{line_.kind, closed, false, false, 0, line_.strength, line_.slope, {}};
        for (const LinePoint& p : points)
            result.points.push_back(
                {lines_.place(p), p.weight, p.gradient, p.opacity, kNoSightNode, false});
        result.points.front().node = piece(begin).nodes[0];
        result.points.back().node = piece(end - 1).nodes[1];
        return result;
    }

    const SightSegments& all_;
    const LineSet& lines_;
    const Polyline& line_;
    const LinePieces pieces_;
    const int passes_;
    const std::uint32_t first_crossing_;
    const bool closed_;
};

/// From `begin` on until the next piece does not go on, or `end`.
LinePieces successive_pieces(const SightPiece* begin, const SightPiece* end,
                             std::uint32_t first_node, std::uint32_t points) {
    const SightPiece* stop = begin + 1;
    while (stop != end && stop[-1].nodes[1] == stop->nodes[0])
        ++stop;
    const bool is_whole =
        begin->nodes[0] == first_node && stop[-1].nodes[1] == first_node + points - 1;
    return {begin, stop, first_node, is_whole};
}

}  // namespace

void trace_surface_lines(const SightSegments& all, const std::vector<SightPiece>& pieces,
                         const std::vector<LineSet>& lines, const SightOptions& options,
                         std::vector<SightLine>& traced) {
    const int passes = smoothing_passes(options.line_smoothing);
    const SightPiece* next = pieces.data();
    const SightPiece* const end = next + pieces.size();
    while (next != end && all.segments[next->segment].line == SightSegment::kNone)
        ++next;
    std::uint32_t number = 0;
    auto first_node = std::uint32_t(all.picture.mesh().positions.size());
    for (const LineSet& set : lines)
        for (const Polyline& line : set.lines) {
            const SightPiece* part = next;
            while (next != end && all.segments[next->segment].line == number)
                ++next;
            while (part != next) {
                const auto found = successive_pieces(part, next, first_node, line.count);
                SurfaceLineTracer(all, set, line, found, passes).trace(traced);
                part = found.end;
            }
            if (!is_edge_kind(line.kind)) first_node += line.count;
            ++number;
        }
}

}  // namespace laplacian_lines
