// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "fixed/line_smoothing.h"
#include "rules/line_rules.h"
#include "visibility/sight_tracing.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

constexpr double kShortestGap = 0.001, kShortestPart = 0.003;  // in D of the line's own surface

/// The pieces of one line, successive in `all`.
struct LinePieces {
    const SightPiece* begin;
    const SightPiece* end;
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
          first_crossing_(first_crossing_node(all)) {}

    void trace(std::vector<SightLine>& traced) const {
        std::vector<bool> is_seen;
        for (const SightPiece* piece = pieces_.begin; piece != pieces_.end; ++piece)
            is_seen.push_back(!piece->is_hidden);
        const double diagonal = own_diagonal();
        turn_short_runs(false, kShortestGap * diagonal, is_seen);
        turn_short_runs(true, kShortestPart * diagonal, is_seen);
        const std::size_t n = is_seen.size();
        const auto hidden = std::find(is_seen.begin(), is_seen.end(), false);
        if (hidden == is_seen.end()) return traced.push_back(part(0, n, line_.closed));
        const auto first = line_.closed ? std::size_t(hidden - is_seen.begin()) : 0;
        for (std::size_t i = 0, end; i < n; i = end) {
            for (end = i; end < n && is_seen[(first + end) % n]; ++end) {
            }
            if (end > i) traced.push_back(part(first + i, first + end, false));
            end += end < n;
        }
    }

private:
    const SightPiece& piece(std::size_t i) const {
        return pieces_.begin[i % std::size_t(pieces_.end - pieces_.begin)];
    }

    std::uint32_t place_of(const SightPiece& piece) const {
        return piece.segment - pieces_.begin->segment;
    }

    /// Of the way along the segment.
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

    /// D of the surface that the line is on, local: the line's length is known in D.
    double own_diagonal() const {
        double sum = 0;
        for (const SightPiece* piece = pieces_.begin; piece != pieces_.end; ++piece)
            sum += length(*piece);
        return line_.length > 0 ? sum / double(line_.length) : 0;
    }

    /// Turns runs of `value` between others that are shorter than `shortest`, local.
    void turn_short_runs(bool value, double shortest, std::vector<bool>& values) const {
        const std::size_t n = values.size();
        const auto other = std::find(values.begin(), values.end(), !value);
        if (other == values.end()) return;
        const auto first = line_.closed ? std::size_t(other - values.begin()) : 0;
        for (std::size_t i = 0, end; i < n; i = end) {
            double sum = 0;
            for (end = i; end < n && values[(first + end) % n] == value; ++end)
                sum += length(piece(first + end));
            // a gap at an open end is none
            const bool is_between = line_.closed || (i > 0 && end < n) || value;
            if (end > i && is_between && sum < shortest)
                for (std::size_t k = i; k < end; ++k)
                    values[(first + k) % n] = !value;
            end += end == i;
        }
    }

    LinePoint point_at(const SightPiece& piece, int end) const {
        const LinePoint& a = lines_.points[line_.first + place_of(piece)];
        const LinePoint& b = lines_.points[line_.first + place_of(piece) + 1];
        const auto t = float(share(piece, end));
        return {a.position + t * (b.position - a.position), a.weight + t * (b.weight - a.weight),
                a.gradient + t * (b.gradient - a.gradient),
                a.opacity + t * (b.opacity - a.opacity)};
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
                {p.position.cast<double>(), p.weight, p.gradient, p.opacity, kNoSightNode, false});
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
};

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
    for (const LineSet& set : lines)
        for (const Polyline& line : set.lines) {
            const SightPiece* const begin = next;
            while (next != end && all.segments[next->segment].line == number)
                ++next;
            if (next != begin)
                SurfaceLineTracer(all, set, line, {begin, next}, passes).trace(traced);
            ++number;
        }
}

}  // namespace laplacian_lines
