// SPDX-License-Identifier: GPL-3.0-or-later
// Creases: the edges that crease_edges.cpp finds, joined to lines. Connected lines are drawn if
// they are long enough together and not ragged.
#include <algorithm>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "fixed/crease_edges.h"
#include "fixed/fixed_lines.h"
#include "fixed/line_copies.h"
#include "fixed/piece_graph.h"
#include "rules/thresholds.h"
#include "system/chains.h"
#include "system/on_demand.h"

namespace laplacian_lines {
namespace {

// Least length of connected creases, in shortest lines: a bad spot of a scan has a few edges.
constexpr float kShortNet = 3;
// Least edges per fault of a scan. Where triangles are as large as the radius of a rounded edge of
// the form, some of their sides are sharp, in zigzags with gaps: ridges draw these better.
constexpr std::uint32_t kPiecesOfAFault = 6;

/// The creases that a style draws, joined to lines.
struct TracedCreases {
    float least_angle, shortest_line;  ///< of the style
    LineSet lines;  ///< points in mesh coordinates; gradient: the largest angle of the edges there
    /// By point, the edge from it to the next point of its line; null for the last.
    std::vector<const CreaseEdge*> edges;
};

/// All lines that are connected.
struct CreaseNet {
    std::uint32_t pieces = 0;
    float length = 0;  ///< D
    /// Loose ends, and facets with exactly two sides among the edges.
    std::uint32_t faults = 0;

    /// Short nets only if designed and without faults, as rims of holes; ragged ones of scans not.
    bool is_drawn(float shortest_line, const CreaseEdges& found) const {
        const bool is_ragged = found.is_scan && pieces < kPiecesOfAFault * faults;
        return !is_ragged &&
               ((found.is_design && faults == 0) || length >= kShortNet * shortest_line);
    }
};

/// Joins the edges that a style with this crease angle shows to lines, which end where other than
/// two of them meet. The edges must outlive the result.
class CreaseTracer {
public:
    CreaseTracer(const CreaseEdges& found, float least_angle) : found_(found) {
        for (const CreaseEdge& edge : found.edges) {
            if (edge.shown_up_to < least_angle) continue;
            edges_.push_back(&edge);
            const std::uint32_t begin = node(edge, 0);
            graph_.add(begin, node(edge, 1));
            for (const std::uint32_t facet : edge.facets)
                if (facet != CreaseEdge::kNone) ++sides_of_facet_[facet];
        }
    }

    /// Appends the lines, once, given the style in `traced`.
    void run(const ExtractorData& data, TracedCreases& traced) {
        const std::vector<PieceGraph::Line> lines = graph_.lines();
        const std::vector<std::uint32_t> net_of = graph_.nets(lines);
        std::vector<CreaseNet> nets(positions_.size());
        for (std::size_t i = 0; i < lines.size(); ++i)
            add(lines[i], nets[net_of[i]]);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const PieceGraph::Line& line = lines[i];
            if (!nets[net_of[i]].is_drawn(traced.shortest_line, found_)) continue;
            const Polyline& appended = append_line(
                data, LineKind::Crease, line,
                [&](std::uint32_t n) -> const Eigen::Vector3f& { return positions_[n]; },
                traced.lines);
            for (std::uint32_t p = 0; p < appended.count; ++p)
                traced.lines.points[appended.first + p].gradient = angles_[line.nodes[p]];
            for (const std::uint32_t piece : line.pieces)
                traced.edges.push_back(edges_[piece]);
            traced.edges.push_back(nullptr);
        }
    }

private:
    std::uint32_t node(const CreaseEdge& edge, int end) {
        const auto [number, is_new] = graph_.node(edge.vertices[end]);
        if (is_new) {
            positions_.push_back(edge.positions[end]);
            angles_.push_back(0);
        }
        angles_[number] = std::max(angles_[number], edge.angle);
        return number;
    }

    void add(const PieceGraph::Line& line, CreaseNet& net) {
        net.pieces += std::uint32_t(line.pieces.size());
        net.faults += loose_ends(line);
        for (const std::uint32_t piece : line.pieces) {
            net.faults += count_facets(*edges_[piece]);
            net.length += edges_[piece]->length();
        }
    }

    /// Facets at an edge with exactly one other side among the edges; none is counted twice.
    std::uint32_t count_facets(const CreaseEdge& edge) {
        std::uint32_t count = 0;
        for (const std::uint32_t facet : edge.facets) {
            if (facet == CreaseEdge::kNone) continue;
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

    const CreaseEdges& found_;
    std::vector<const CreaseEdge*> edges_;  // by piece
    PieceGraph graph_;
    std::vector<Eigen::Vector3f> positions_;  // by node
    std::vector<float> angles_;               // the largest of the edges there, by node
    std::unordered_map<std::uint32_t, std::uint32_t> sides_of_facet_;
};

/// What becomes of an edge for an eye.
enum class EdgeView {
    Shown,    ///< drawn; what hides it is in front of it
    Away,     ///< faces away on a closed body, which hides it
    Horizon,  ///< one of its triangles faces the eye: a contour is drawn there instead
};

struct EdgeFacing {
    const LocalEye eye;
    const bool has_contours;
    const bool hides_back;  ///< what faces away is hidden: a body, seen from outside

    EdgeView of(const CreaseEdge& edge) const {
        if (!has_contours) return EdgeView::Shown;
        const Eigen::Vector3f l = eye.towards(edge.positions[0]);
        const bool one = dot(edge.normals[0], l) < 0, other = dot(edge.normals[1], l) < 0;
        if (one != other) return EdgeView::Horizon;
        return one && hides_back ? EdgeView::Away : EdgeView::Shown;
    }
};

/// Appends the parts of a line that are not on the horizon. Those that face away have a slope below
/// zero.
void append_parts(const TracedCreases& traced, const Polyline& line, const EdgeFacing& facing,
                  LineSet& lines) {
    const std::size_t edges = line.count - 1;
    const auto edge = [&](std::size_t i) -> const CreaseEdge& {
        return *traced.edges[line.first + i % edges];
    };
    for (const EdgeView view : {EdgeView::Shown, EdgeView::Away}) {
        const auto is_in = [&](std::size_t i) { return facing.of(edge(i)) == view; };
        for_each_run(edges, line.closed, is_in, [&](std::size_t begin, std::size_t count) {
            Polyline& part = append_points(traced.lines, line, begin, count + 1, lines);
            part.length = 0;
            for (std::size_t i = begin; i < begin + count; ++i)
                part.length += edge(i).length();
            if (view == EdgeView::Away) part.slope = -1;
        });
    }
}

class Creases : public FixedKindLines {
public:
    Creases(const ExtractorData&, FixedLines&) {}

    void append(const ExtractorData& data, FixedLines& all, const LocalEye& eye,
                const LineStyle& style, LineSet& lines) const override {
        const EdgeFacing facing{eye, style.shows[LineKind::Contour],
                                data.is_body && !may_be_within(eye)};
        const auto traced = trace(data, all, style);
        for (const Polyline& line : traced->lines.lines)
            append_parts(*traced, line, facing, lines);
    }

    std::shared_ptr<const LineSet> whole(const ExtractorData& data, FixedLines& all,
                                         const LineStyle& style) const override {
        const auto traced = trace(data, all, style);
        return {traced, &traced->lines};
    }

private:
    /// Caches the result for the last style. Thread-safe.
    std::shared_ptr<const TracedCreases> trace(const ExtractorData& data, FixedLines& all,
                                               const LineStyle& style) const {
        const auto least_angle = float(style.crease_angle);
        const float shortest_line = Thresholds(style).shortest_line;
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!traced_ || traced_->least_angle != least_angle ||
            traced_->shortest_line != shortest_line) {
            auto traced = std::make_shared<TracedCreases>();
            traced->least_angle = least_angle;
            traced->shortest_line = shortest_line;
            CreaseTracer(edges(data, all), least_angle).run(data, *traced);
            traced_ = std::move(traced);
        }
        return traced_;
    }

    const CreaseEdges& edges(const ExtractorData& data, FixedLines& all) const {
        return edges_.get([&] {
            // the edges of rough meshes are those of noise or of voxels
            return data.is_rough ? CreaseEdges() : find_crease_edges(data, *all.surface(data));
        });
    }

    mutable OnDemand<CreaseEdges> edges_;
    mutable std::mutex mutex_;
    mutable std::shared_ptr<const TracedCreases> traced_;
};

}  // namespace

const FixedKind kCreases = fixed_kind<Creases>(LineKind::Crease);

}  // namespace laplacian_lines
