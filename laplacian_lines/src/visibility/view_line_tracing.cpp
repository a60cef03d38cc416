// SPDX-License-Identifier: GPL-3.0-or-later
// Visible pieces become lines:
//  1. Those that are wanted are kept, without short contours.
//  2. Ends of pieces of one class that meet at a node are linked: two always; of more the
//     straightest pairs first, and straight ones only, but all of outlines, for outlines close.
//  3. What is linked is a line, smoothed between its exact points.
// Ends of pieces are numbered: 2 p is the first of piece p, 2 p + 1 its last.
#include "visibility/visibility_pieces.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "fixed/line_smoothing.h"
#include "fixed/piece_graph.h"
#include "rules/line_rules.h"
#include "system/disjoint_sets.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kMostAtNode = 64;  // ends; of more only outlines are joined
constexpr double kStraight = 0.5;  // least cosine of the turn at which a line passes a junction

class ViewLineTracer {
public:
    /// Of edges, or of lines on the surface.
    ViewLineTracer(const VisibilitySegments& all, const std::vector<VisibilityPiece>& pieces,
                   const VisibilityOptions& options, bool of_edges)
        : all_(all), options_(options), of_edges_(of_edges), first_crossing_(all.point_count()) {
        for (const VisibilityPiece& piece : pieces)
            if (is_wanted(piece)) pieces_.push_back(piece);
        if (of_edges && options.shortest_contour > 0) drop_short_contours();
        nodes_.assign(2 * pieces_.size(), kNone);
    }

    void trace(std::vector<ViewLine>& traced) {
        if (of_edges_)
            link_at_nodes();
        else
            link_successive();
        for (std::uint32_t& node : nodes_)
            if (node == kNone) node = graph_.add_node();
        for (std::size_t piece = 0; piece < pieces_.size(); ++piece)
            graph_.add(nodes_[2 * piece], nodes_[2 * piece + 1]);
        for (const PieceGraph::Line& line : graph_.lines()) {
            traced.push_back(view_line(line));
            if (!of_edges_ || !options_.in_picture) smooth(traced.back());
            if (!of_edges_) describe_line(segment_of(2 * line.pieces[0]).line, traced.back());
        }
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;

    const VisibilitySegment& segment_of(std::uint32_t end) const {
        return all_.segments[pieces_[end / 2].segment];
    }

    bool is_wanted(const VisibilityPiece& piece) const {
        const VisibilitySegment& segment = all_.segments[piece.segment];
        if ((segment.edge != VisibilitySegment::kNone) != of_edges_) return false;
        const bool may_be_hidden = of_edges_ && options_.has_hidden;
        return (!of_edges_ || options_.shows[segment.kind]) && (may_be_hidden || !piece.is_hidden);
    }

    /// Drops contours and borders in connected sets smaller than the shortest contour, which rough
    /// scans have near their horizon.
    void drop_short_contours() {
        std::uint32_t nodes = 0;
        for (const VisibilityPiece& piece : pieces_)
            nodes = std::max({nodes, piece.nodes[0] + 1, piece.nodes[1] + 1});
        DisjointSets sets(nodes);
        for (const VisibilityPiece& piece : pieces_)
            if (!piece.is_hidden) sets.unite(piece.nodes[0], piece.nodes[1]);
        const std::vector<std::uint32_t> set = sets.take_roots();
        std::vector<std::uint32_t> first(nodes, kNone);  // end of each set
        std::vector<double> reach(nodes);                // from it
        for (std::uint32_t end = 0; end < 2 * pieces_.size(); ++end) {
            const std::uint32_t at = set[pieces_[end / 2].nodes[end % 2]];
            if (pieces_[end / 2].is_hidden) continue;
            if (first[at] == kNone) first[at] = end;
            reach[at] = std::max(reach[at], (position(end) - position(first[at])).norm());
        }
        const double shortest = options_.shortest_contour * all_.picture.mesh().size;
        const auto is_short = [&](const VisibilityPiece& piece) {
            return !piece.is_hidden && describe(all_.segments[piece.segment].kind).bounds_form &&
                   reach[set[piece.nodes[0]]] < shortest;
        };
        pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), is_short), pieces_.end());
    }

    static constexpr int kOutlines = -1;

    /// Only pieces of one class are joined; near edges of faces seen edge-on are a class.
    int class_of(std::uint32_t end) const {
        const VisibilityPiece& piece = pieces_[end / 2];
        if (options_.in_picture && piece.is_outline) return kOutlines;
        const VisibilitySegment& segment = segment_of(end);
        const bool bounds_form = describe(segment.kind).bounds_form;
        if (bounds_form && !segment.divides) return 2 * int(kLineKindCount) + piece.is_hidden;
        const int kind = options_.in_picture && bounds_form ? 0 : int(segment.kind);
        return 2 * kind + piece.is_hidden;
    }

    /// Node, segment and class: ends of pieces are linked if theirs are the same. In space, each of
    /// the two segments of a crossing has a node of its own.
    using Key = std::tuple<std::uint32_t, std::uint32_t, int>;
    Key key_of(std::uint32_t end) const {
        const VisibilityPiece& piece = pieces_[end / 2];
        const std::uint32_t node = piece.nodes[end % 2];
        const bool is_in_space = node >= first_crossing_ && !options_.in_picture;
        return {node, is_in_space ? piece.segment : 0, class_of(end)};
    }

    /// Links the pieces of lines on the surface, which are in order.
    void link_successive() {
        const auto line_of = [&](std::uint32_t piece) { return segment_of(2 * piece).line; };
        for (std::uint32_t piece = 0, first = 0; piece < pieces_.size(); ++piece) {
            if (line_of(piece) != line_of(first)) first = piece;
            const bool is_last =
                piece + 1 == pieces_.size() || line_of(piece + 1) != line_of(piece);
            const std::uint32_t next = is_last ? first : piece + 1;
            if (pieces_[piece].nodes[1] == pieces_[next].nodes[0]) join(2 * piece + 1, 2 * next);
        }
    }

    void link_at_nodes() {
        std::vector<std::pair<Key, std::uint32_t>> ends;
        for (std::uint32_t end = 0; end < nodes_.size(); ++end)
            ends.emplace_back(key_of(end), end);
        std::sort(ends.begin(), ends.end());
        std::vector<std::uint32_t> meeting;
        for (std::size_t i = 0; i < ends.size();) {
            const Key& key = ends[i].first;
            meeting.clear();
            for (; i < ends.size() && ends[i].first == key; ++i)
                meeting.push_back(ends[i].second);
            link(meeting, std::get<int>(key) == kOutlines);
        }
    }

    void join(std::uint32_t a, std::uint32_t b) { nodes_[a] = nodes_[b] = graph_.add_node(); }

    /// Links pieces at a node: two of them, or the straightest pairs; of a great many only
    /// outlines, which have to close.
    void link(const std::vector<std::uint32_t>& ends, bool are_outlines) {
        if (ends.size() == 2) return join(ends[0], ends[1]);
        if (ends.size() > kMostAtNode) {
            for (std::size_t i = 1; are_outlines && i < ends.size(); i += 2)
                join(ends[i - 1], ends[i]);
            return;
        }
        std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> pairs;
        for (std::size_t k = 1; k < ends.size(); ++k)
            for (std::size_t i = 0; i < k; ++i) {
                // −1: straight on
                const double cosine = direction(ends[i]).dot(direction(ends[k]));
                if (are_outlines || cosine < -kStraight)
                    pairs.emplace_back(cosine, ends[i], ends[k]);
            }
        std::sort(pairs.begin(), pairs.end());
        for (const auto& [cosine, a, b] : pairs)
            if (nodes_[a] == kNone && nodes_[b] == kNone) join(a, b);
    }

    /// The direction of a piece from one of its ends, in the picture.
    Vector2d direction(std::uint32_t end) const {
        const VisibilitySegment& segment = segment_of(end);
        const Vector3d along =
            all_.projected(segment.points[1]) - all_.projected(segment.points[0]);
        return (end % 2 == 0 ? 1 : -1) * along.head<2>().stableNormalized();
    }

    Vector3d position(std::uint32_t end) const {
        const double share = pieces_[end / 2].shares[end % 2];
        return all_.picture.mesh().in_mesh(all_.position_at(segment_of(end), share));
    }

    ViewLinePoint point_at(std::uint32_t end) const {
        const VisibilityPiece& piece = pieces_[end / 2];
        const VisibilitySegment& segment = segment_of(end);
        ViewLinePoint point{position(end), 1, 0, 1, piece.nodes[end % 2], segment.is_exact};
        if (of_edges_) return point;
        const VisibilitySegments::Line& of = all_.lines[segment.line];
        const LinePoint* const a =
            &of.set->points[of.line->first + segment.points[0] - of.first_point];
        const double share = all_.share_in_space(segment, piece.shares[end % 2]);
        // not from local coordinates, which may be coarser than the line's
        point.position = (1 - share) * of.set->position(a[0]) + share * of.set->position(a[1]);
        const auto t = float(share);
        const auto between = [&](float LinePoint::*value) {
            return (1 - t) * a[0].*value + t * a[1].*value;
        };
        point.weight = between(&LinePoint::weight);
        point.gradient = between(&LinePoint::gradient);
        point.opacity = between(&LinePoint::opacity);
        return point;
    }

    ViewLine view_line(const PieceGraph::Line& traced) const {
        const VisibilityPiece& first = pieces_[traced.pieces[0]];
        const LineKind kind = all_.segments[first.segment].kind;
        ViewLine line{kind, traced.is_closed, first.is_hidden, first.is_outline, 0, 0, 0, {}};
        std::uint32_t last = kNone;  // the end by which the line left the piece before
        for (std::size_t i = 0; i < traced.pieces.size(); ++i) {
            const std::uint32_t piece = traced.pieces[i];
            const std::uint32_t end = 2 * piece + (nodes_[2 * piece] != traced.nodes[i]);
            line.jump = std::max(line.jump, pieces_[piece].gap);
            line.points.push_back(point_at(end));
            line.points.back().is_exact |= last != kNone && segment_of(last).is_exact;
            last = end ^ 1;
        }
        line.jump *= float(all_.picture.mesh().size);
        line.points.push_back(point_at(last));
        if (line.closed) {
            line.points.front().is_exact |= segment_of(last).is_exact;
            line.points.back() = line.points.front();
        }
        return line;
    }

    /// Lines on the surface have nodes only at their ends, and no depth jumps.
    void describe_line(std::uint32_t number, ViewLine& line) const {
        line.jump = 0;
        line.strength = all_.lines[number].line->strength;
        line.slope = all_.lines[number].line->slope;
        for (std::size_t i = 1; i + 1 < line.points.size(); ++i)
            line.points[i].node = kNoNode;
    }

    /// Smooths between exact points and open ends. Removes the points of a smooth line where it is
    /// only crossed in the picture, since they would disturb that.
    void smooth(ViewLine& line) const {
        const auto is_passed = [&](const ViewLinePoint& point) {
            return !point.is_exact && point.node >= first_crossing_;
        };
        std::vector<ViewLinePoint>& points = line.points;
        if (line.closed) points.pop_back();
        const auto from = points.begin() + !line.closed, to = points.end() - !line.closed;
        points.erase(std::remove_if(from, to, is_passed), to);
        if (line.closed) points.push_back(ViewLinePoint(points.front()));
        const std::size_t last = points.size() - 1;
        if (last < 2) return;
        smooth_binomially(
            points.size(), line.closed, smoothing_passes(options_.line_smoothing),
            [&](std::size_t i) { return points[i].position; },
            [&](std::size_t i, const Vector3d& p) {
                const bool is_end = !line.closed && (i == 0 || i == last);
                if (!points[i].is_exact && !is_end) points[i].position = p;
            });
    }

    const VisibilitySegments& all_;
    const VisibilityOptions& options_;
    const bool of_edges_;
    const std::uint32_t first_crossing_;
    std::vector<VisibilityPiece> pieces_;
    PieceGraph graph_;
    std::vector<std::uint32_t> nodes_;  // of graph_, by end
};

}  // namespace

std::vector<ViewLine> trace_lines(const VisibilitySegments& all,
                                  const std::vector<VisibilityPiece>& pieces,
                                  const VisibilityOptions& options) {
    std::vector<ViewLine> traced;
    for (const bool of_edges : {true, false})
        ViewLineTracer(all, pieces, options, of_edges).trace(traced);
    return traced;
}

}  // namespace laplacian_lines
