// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>

#include "fixed/line_smoothing.h"
#include "rules/line_rules.h"
#include "system/chains.h"
#include "system/disjoint_sets.h"
#include "visibility/sight_pieces.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kMostAtNode = 64;  // of more, nobody sees which go on into each other
constexpr double kStraight = 0.5;  // least cosine of the turn at which a line passes a junction

class EdgeTracer {
public:
    EdgeTracer(const SightSegments& all, const std::vector<SightPiece>& pieces,
               const SightOptions& options)
        : all_(all), options_(options), first_crossing_(first_crossing_node(all)) {
        for (const SightPiece& piece : pieces)
            if (is_wanted(piece)) pieces_.push_back(piece);
        if (options.shortest_contour > 0) leave_out_specks();
        link_.assign(2 * pieces_.size(), kNoEnd);
        visited_.assign(pieces_.size(), false);
    }

    void trace(std::vector<SightLine>& traced) {
        link_at_nodes();
        for_each_chain(
            std::uint32_t(pieces_.size()), [&](std::uint32_t half) { return link_[half]; },
            [&](std::uint32_t half) {
                if (visited_[half / 2]) return;
                traced.push_back(line_from(half));
                if (!options_.in_picture) finish_in_space(traced.back());
            });
    }

private:
    const SightSegment& segment_of(std::uint32_t half) const {
        return all_.segments[pieces_[half / 2].segment];
    }

    bool is_wanted(const SightPiece& piece) const {
        const SightSegment& segment = all_.segments[piece.segment];
        return segment.edge != SightSegment::kNone && options_.shows[segment.kind] &&
               (options_.has_hidden || !piece.is_hidden);
    }

    /// Drops dots where a scan's roughness is on its horizon: contours and borders that meet
    /// nothing else that is seen, and reach nowhere.
    void leave_out_specks() {
        std::uint32_t nodes = 0;
        for (const SightPiece& piece : pieces_)
            nodes = std::max({nodes, piece.nodes[0] + 1, piece.nodes[1] + 1});
        DisjointSets sets(nodes);
        for (const SightPiece& piece : pieces_)
            if (!piece.is_hidden) sets.unite(piece.nodes[0], piece.nodes[1]);
        const std::vector<std::uint32_t> set = sets.take_roots();
        std::vector<std::uint32_t> first(nodes, kNoEnd);  // half of a set
        std::vector<double> reach(nodes);                 // from it
        for (std::uint32_t half = 0; half < 2 * pieces_.size(); ++half) {
            const std::uint32_t at = set[pieces_[half / 2].nodes[half % 2]];
            if (pieces_[half / 2].is_hidden) continue;
            if (first[at] == kNoEnd) first[at] = half;
            reach[at] = std::max(reach[at], (position(half) - position(first[at])).norm());
        }
        const double shortest = options_.shortest_contour * all_.picture.mesh().size;
        const auto is_speck = [&](const SightPiece& piece) {
            return !piece.is_hidden && describe(all_.segments[piece.segment].kind).is_outline &&
                   reach[set[piece.nodes[0]]] < shortest;
        };
        pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), is_speck), pieces_.end());
    }

    /// Pieces of one class go on into each other; near edges of walls only among themselves.
    int class_of(std::uint32_t half) const {
        const SightPiece& piece = pieces_[half / 2];
        if (options_.in_picture && piece.is_outline) return -1;
        const SightSegment& segment = segment_of(half);
        const bool is_outline = describe(segment.kind).is_outline;
        if (is_outline && !segment.divides) return 2 * int(line_kind_count) + piece.is_hidden;
        const int kind = options_.in_picture && is_outline ? 0 : int(segment.kind);
        return 2 * kind + piece.is_hidden;
    }

    /// In space, a crossing is a node of each of its segments.
    std::pair<std::uint32_t, std::uint32_t> node_of(std::uint32_t half) const {
        const SightPiece& piece = pieces_[half / 2];
        const std::uint32_t node = piece.nodes[half % 2];
        const bool is_in_space = node >= first_crossing_ && !options_.in_picture;
        return {node, is_in_space ? piece.segment : 0};
    }

    void link_at_nodes() {
        std::vector<std::tuple<std::pair<std::uint32_t, std::uint32_t>, int, std::uint32_t>> halves;
        for (std::uint32_t half = 0; half < link_.size(); ++half)
            halves.emplace_back(node_of(half), class_of(half), half);
        std::sort(halves.begin(), halves.end());
        std::vector<std::uint32_t> meeting;
        for (std::size_t begin = 0, end; begin < halves.size(); begin = end) {
            meeting.clear();
            for (end = begin;
                 end < halves.size() && std::get<0>(halves[end]) == std::get<0>(halves[begin]) &&
                 std::get<1>(halves[end]) == std::get<1>(halves[begin]);
                 ++end)
                meeting.push_back(std::get<2>(halves[end]));
            link(meeting, std::get<1>(halves[begin]) == -1);
        }
    }

    void join(std::uint32_t a, std::uint32_t b) {
        link_[a] = b;
        link_[b] = a;
    }

    /// Two continue each other; of more, the straightest pairs; of a great many, only outlines,
    /// which have to close.
    void link(std::vector<std::uint32_t>& halves, bool are_outlines) {
        if (halves.size() == 2) return join(halves[0], halves[1]);
        if (halves.size() > kMostAtNode) {
            for (std::size_t i = 1; are_outlines && i < halves.size(); i += 2)
                join(halves[i - 1], halves[i]);
            return;
        }
        const double least = are_outlines ? -2 : kStraight;
        while (halves.size() > 1) {
            double best = least;
            std::size_t first = 0, second = 0;
            for (std::size_t i = 0; i < halves.size(); ++i)
                for (std::size_t k = i + 1; k < halves.size(); ++k) {
                    const double straightness = -direction(halves[i]).dot(direction(halves[k]));
                    if (straightness > best) {
                        best = straightness;
                        first = i;
                        second = k;
                    }
                }
            if (first == second) return;
            join(halves[first], halves[second]);
            halves.erase(halves.begin() + std::ptrdiff_t(second));
            halves.erase(halves.begin() + std::ptrdiff_t(first));
        }
    }

    /// The direction of a piece from one of its ends, in the picture.
    Vector2d direction(std::uint32_t half) const {
        const SightSegment& segment = segment_of(half);
        const Vector3d along = all_.place(segment.points[1]) - all_.place(segment.points[0]);
        return (half % 2 == 0 ? 1 : -1) * along.head<2>().stableNormalized();
    }

    Vector3d position(std::uint32_t half) const {
        const SightPiece& piece = pieces_[half / 2];
        const SightSegment& segment = segment_of(half);
        const double share = all_.picture.share_in_space(
            all_.place(segment.points[0]), all_.place(segment.points[1]), piece.shares[half % 2]);
        const Vector3d &a = all_.position(segment.points[0]), &b = all_.position(segment.points[1]);
        return all_.picture.mesh().in_mesh(a + share * (b - a));
    }

    /// An end of a piece, with what that piece alone knows.
    SightPoint point_at(std::uint32_t half) const {
        return {position(half),           1, 0, 1, pieces_[half / 2].nodes[half % 2],
                segment_of(half).is_exact};
    }

    SightLine line_from(std::uint32_t start) {
        const SightPiece& piece = pieces_[start / 2];
        SightLine line{
            segment_of(start).kind, false, piece.is_hidden, piece.is_outline, 0, 0, 0, {}};
        std::uint32_t last = start;
        line.closed = follow_chain(
            start, [&](std::uint32_t half) { return link_[half]; },
            [&](std::uint32_t half) {
                visited_[half / 2] = true;
                line.jump = std::max(line.jump, pieces_[half / 2].gap);
                line.points.push_back(point_at(half));
                line.points.back().is_exact |= half != start && segment_of(last).is_exact;
                last = half ^ 1;
            });
        line.jump *= float(all_.picture.mesh().size);
        line.points.push_back(point_at(last));
        if (line.closed) {
            line.points.front().is_exact |= segment_of(last).is_exact;
            line.points.back() = line.points.front();
        }
        return line;
    }

    /// Smooths between exact points and open ends. A smooth line that is merely crossed in the
    /// picture has no point there in space, which would hinder that.
    void finish_in_space(SightLine& line) const {
        const auto is_passed = [&](const SightPoint& point) {
            return !point.is_exact && point.node >= first_crossing_;
        };
        std::vector<SightPoint>& points = line.points;
        if (line.closed) points.pop_back();
        const auto from = points.begin() + !line.closed, to = points.end() - !line.closed;
        points.erase(std::remove_if(from, to, is_passed), to);
        if (line.closed) points.push_back(SightPoint(points.front()));
        const std::size_t last = points.size() - 1;
        if (last < 2) return;
        smooth_binomially(
            points.size(), line.closed, smoothing_passes(options_.line_smoothing),
            [&](std::size_t i) -> Vector3d& { return points[i].position; },
            [&](std::size_t i) {
                return points[i].is_exact || (!line.closed && (i == 0 || i == last));
            });
    }

    const SightSegments& all_;
    const SightOptions& options_;
    const std::uint32_t first_crossing_;
    std::vector<SightPiece> pieces_;
    std::vector<std::uint32_t> link_;  // by half: end 2p and 2p + 1 of piece p
    std::vector<bool> visited_;
};

}  // namespace

void trace_edges(const SightSegments& all, const std::vector<SightPiece>& pieces,
                 const SightOptions& options, std::vector<SightLine>& traced) {
    EdgeTracer(all, pieces, options).trace(traced);
}

}  // namespace laplacian_lines
