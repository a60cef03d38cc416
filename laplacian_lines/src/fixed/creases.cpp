// SPDX-License-Identifier: GPL-3.0-or-later
// Creases: edges of the form, see crease_edges.cpp, joined to lines. Drawn are those that are long
// enough together and not ragged.
#include <algorithm>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "fixed/crease_edges.h"
#include "fixed/fixed_lines.h"
#include "fixed/piece_graph.h"
#include "rules/thresholds.h"
#include "system/disjoint_sets.h"
#include "system/on_demand.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kFewPieces = 12;  // connected ones, that a bad place of a scan may have
constexpr float kShortNet = 3;            // shortest lines
// Of rounded edges whose triangles are as large as their radius, some are as sharp as creases, here
// and there and to and fro: ridges tell them better.
constexpr float kRaggedPiece = 0.015f;        // D; longer ones are those of a form
constexpr std::uint32_t kPiecesOfAFault = 6;  // fewer to a fault are ragged

/// The creases that a style's angle leaves, joined to lines.
struct TracedCreases {
    float least_angle;  ///< of the style
    LineSet lines;      ///< points in mesh coordinates; gradient: the larger angle of the edges
    /// Which edge goes on from a point to the next one of its line, by point; none from the last.
    std::vector<const CreaseEdge*> edges;
    /// What belongs together: all lines that are connected with a line, or a line with a loose end
    /// alone, by line.
    struct Net {
        std::uint32_t pieces = 0;
        float length = 0;  ///< D
        /// Loose ends; and facets between two of the edges, whose third side is bent but none of
        /// them.
        std::uint32_t faults = 0;
    };
    std::vector<Net> nets;
};

/// Joins the edges that a style with this crease angle shows to lines, which end where other than
/// two of them meet. The edges must outlive the result.
class CreaseTracer {
public:
    CreaseTracer(const std::vector<CreaseEdge>& edges, float least_angle) {
        for (const CreaseEdge& edge : edges) {
            if (edge.shown_up_to < least_angle) continue;
            edges_.push_back(&edge);
            const std::uint32_t begin = node(edge, 0);
            graph_.add(begin, node(edge, 1));
            for (const std::uint32_t facet : edge.facets)
                if (facet != TriangleGraph::kNone) ++sides_of_facet_[facet];
        }
    }

    void run(const ExtractorData& data, TracedCreases& traced) {
        const std::vector<PieceGraph::Line> lines = graph_.lines();
        for (const PieceGraph::Line& line : lines) {
            append_line(
                data, LineKind::Crease, line,
                [&](std::uint32_t n) -> const Eigen::Vector3f& { return positions_[n]; },
                traced.lines);
            const Polyline& appended = traced.lines.lines.back();
            for (std::uint32_t i = 0; i < appended.count; ++i)
                traced.lines.points[appended.first + i].gradient = angles_[line.nodes[i]];
            for (const std::uint32_t piece : line.pieces)
                traced.edges.push_back(edges_[piece]);
            traced.edges.push_back(nullptr);
            traced.nets.push_back(net_of(line, appended.length));
        }
        join_nets(lines, traced.nets);
    }

private:
    std::uint32_t node(const CreaseEdge& edge, int end) {
        const std::uint32_t number = graph_.node(edge.vertices[end]);
        if (number == positions_.size()) {
            positions_.push_back(edge.positions[end]);
            angles_.push_back(0);
        }
        angles_[number] = std::max(angles_[number], edge.angle);
        return number;
    }

    /// Of a line alone.
    TracedCreases::Net net_of(const PieceGraph::Line& line, float length) {
        TracedCreases::Net net;
        net.pieces = std::uint32_t(line.pieces.size());
        net.length = length;
        if (!line.is_closed) net.faults += loose_ends(line);
        for (const std::uint32_t piece : line.pieces)
            net.faults += count_facets(*edges_[piece]);
        return net;
    }

    /// Facets at an edge that have just one other side among the edges; each counts once.
    std::uint32_t count_facets(const CreaseEdge& edge) {
        std::uint32_t count = 0;
        for (const std::uint32_t facet : edge.facets) {
            if (facet == TriangleGraph::kNone) continue;
            std::uint32_t& sides = sides_of_facet_[facet];
            count += sides == 2;
            sides = 0;
        }
        return count;
    }

    std::uint32_t loose_ends(const PieceGraph::Line& line) const {
        return std::uint32_t(graph_.pieces_at(line.nodes.front()) == 1) +
               (graph_.pieces_at(line.nodes.back()) == 1);
    }

    /// Of lines alone, those of what is connected.
    void join_nets(const std::vector<PieceGraph::Line>& lines,
                   std::vector<TracedCreases::Net>& nets) const {
        DisjointSets connected(graph_.node_count());
        for (const PieceGraph::Line& line : lines)
            connected.unite(line.nodes.front(), line.nodes.back());
        std::vector<TracedCreases::Net> joined(graph_.node_count());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            TracedCreases::Net& all = joined[connected.root(lines[i].nodes[0])];
            all.pieces += nets[i].pieces;
            all.length += nets[i].length;
            all.faults += nets[i].faults;
        }
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (loose_ends(lines[i]) == 0) nets[i] = joined[connected.root(lines[i].nodes[0])];
    }

    std::vector<const CreaseEdge*> edges_;  // by piece
    PieceGraph graph_;
    std::vector<Eigen::Vector3f> positions_;  // by node
    std::vector<float> angles_;               // the largest of the edges there, by node
    std::unordered_map<std::uint32_t, std::uint32_t> sides_of_facet_;
};

/// How an edge lies to the eye.
enum class EdgeView {
    Towards,  ///< both of its triangles face the eye, or no contours are drawn
    Away,     ///< none does, and the body that it is on hides it
    Horizon,  ///< one does: there is a contour
};

class EdgeFacing {
public:
    EdgeFacing(const LocalEye& eye, bool has_contours, bool is_body)
        : eye_(eye), has_contours_(has_contours), is_body_(is_body) {}

    EdgeView of(const CreaseEdge& edge) const {
        if (!has_contours_) return EdgeView::Towards;
        const Eigen::Vector3f l = eye_.towards(edge.positions[0]);
        const bool one = dot(edge.normals[0], l) < 0, other = dot(edge.normals[1], l) < 0;
        if (one != other) return EdgeView::Horizon;
        return one && is_body_ ? EdgeView::Away : EdgeView::Towards;
    }

private:
    const LocalEye eye_;
    const bool has_contours_, is_body_;
};

void append_part(const TracedCreases& traced, const Polyline& line, std::uint32_t from,
                 std::uint32_t edges, LineSet& lines) {
    Polyline part = line;
    part.closed = line.closed && edges == line.count - 1;
    part.first = std::uint32_t(lines.points.size());
    part.count = edges + 1;
    part.length = 0;
    for (std::uint32_t i = 0; i <= edges; ++i) {
        const std::uint32_t place = line.first + (from + i) % (line.count - 1);
        const bool is_last = from + i == line.count - 1;
        lines.points.push_back(traced.lines.points[is_last ? line.first + line.count - 1 : place]);
        if (i < edges) part.length += traced.edges[place]->length();
    }
    lines.lines.push_back(part);
}

/// Appends the parts of a line that are not on the horizon. Those that face away have a slope below
/// zero.
void append_line(const TracedCreases& traced, const Polyline& line, const EdgeFacing& facing,
                 LineSet& lines) {
    const std::uint32_t edges = line.count - 1;
    const auto of = [&](std::uint32_t i) {
        return facing.of(*traced.edges[line.first + i % edges]);
    };
    std::uint32_t start = 0;  // of a closed line, where it begins to face otherwise, if it does
    if (line.closed)
        while (start < edges && of(start) == of(start + edges - 1))
            ++start;
    if (start == edges) start = 0;
    for (std::uint32_t i = start, end; i < start + edges; i = end) {
        for (end = i + 1; end < start + edges && of(end) == of(i); ++end) {
        }
        if (of(i) == EdgeView::Horizon) continue;
        append_part(traced, line, i % edges, end - i, lines);
        if (of(i) == EdgeView::Away) lines.lines.back().slope = -1;
    }
}

class Creases : public FixedKindLines {
public:
    explicit Creases(const ExtractorData&) {}

    void append(const ExtractorData& data, FixedLines&, const LocalEye& eye, const LineStyle& style,
                LineSet& lines) const override {
        const EdgeFacing facing(eye, style.shows[LineKind::Contour],
                                data.is_body && !may_be_within(eye));
        append_drawn(*trace(data, float(style.crease_angle)), Thresholds(style).shortest_line,
                     facing, lines);
    }

    std::shared_ptr<const LineSet> whole(const ExtractorData& data,
                                         const LineStyle& style) const override {
        const auto traced = trace(data, float(style.crease_angle));
        const float shortest = Thresholds(style).shortest_line;
        const std::lock_guard<std::mutex> lock(mutex_);
        if (whole_of_ != traced || shortest_ != shortest) {
            auto lines = std::make_shared<LineSet>();
            const LocalEye any{Eigen::Vector3f::Zero(), 0};
            append_drawn(*traced, shortest, EdgeFacing(any, false, false), *lines);
            whole_ = std::move(lines);
            whole_of_ = traced;
            shortest_ = shortest;
        }
        return whole_;
    }

private:
    static void append_drawn(const TracedCreases& traced, float shortest, const EdgeFacing& facing,
                             LineSet& lines) {
        for (std::size_t i = 0; i < traced.nets.size(); ++i) {
            const TracedCreases::Net& net = traced.nets[i];
            const bool is_ragged = net.pieces < kPiecesOfAFault * net.faults &&
                                   net.length < kRaggedPiece * float(net.pieces);
            if (!is_ragged && (net.pieces >= kFewPieces || net.length >= kShortNet * shortest))
                append_line(traced, traced.lines.lines[i], facing, lines);
        }
    }

    /// Those of the last angle that was asked for are kept. Thread-safe.
    std::shared_ptr<const TracedCreases> trace(const ExtractorData& data, float least_angle) const {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!traced_ || traced_->least_angle != least_angle) {
            auto traced = std::make_shared<TracedCreases>();
            traced->least_angle = least_angle;
            CreaseTracer(edges(data, least_angle), least_angle).run(data, *traced);
            traced_ = std::move(traced);
        }
        return traced_;
    }

    /// Smaller angles than the default one are seldom asked for, and take long on rough scans.
    const std::vector<CreaseEdge>& edges(const ExtractorData& data, float least_angle) const {
        const float least = least_angle < kEdgeAngle ? 0 : kEdgeAngle;
        return (least > 0 ? edges_ : more_edges_).get([&] {
            return find_crease_edges(data, least);
        });
    }

    mutable OnDemand<std::vector<CreaseEdge>> edges_, more_edges_;
    mutable std::mutex mutex_;
    mutable std::shared_ptr<const TracedCreases> traced_, whole_of_;
    mutable float shortest_ = 0;                    // that whole_ belongs to, as does whole_of_
    mutable std::shared_ptr<const LineSet> whole_;  // what is drawn, wherever the eye is
};

}  // namespace

const FixedKind creases = fixed_kind<Creases>(LineKind::Crease);

}  // namespace laplacian_lines
