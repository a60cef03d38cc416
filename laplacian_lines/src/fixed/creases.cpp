// SPDX-License-Identifier: GPL-3.0-or-later
// Creases: chains of edges of the mesh at which the form has an edge.
#include <memory>
#include <mutex>

#include "fixed/crease_criteria.h"
#include "fixed/crease_tracing.h"
#include "fixed/fixed_kinds.h"
#include "fixed/showing.h"
#include "system/on_demand.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kFewPieces = 12;  // connected ones, that a bad place of a scan may have
constexpr float kShortNet = 3;            // shortest lines
// Of rounded edges whose triangles are as large as their radius, some are as sharp as creases, here
// and there and to and fro: ridges tell them better.
constexpr float kRaggedPiece = 0.015f;        // D; longer ones are those of a form
constexpr std::uint32_t kPiecesOfAFault = 6;  // fewer to a fault are ragged

/// How an edge lies to the eye.
enum class EdgeView {
    Towards,  ///< both of its triangles face the eye, or no contours are drawn
    Away,     ///< none does, and the body that it is on hides it
    Horizon,  ///< one does: there is a contour
};

class EdgeFacing {
public:
    EdgeFacing(const LocalEye& eye, const LineStyle& style, bool is_body)
        : eye_(eye), has_contours_(style.shows[LineKind::Contour]), is_body_(is_body) {}

    EdgeView of(const CreaseEdge& edge) const {
        const Eigen::Vector3f l = eye_.towards(edge.positions[0]);
        const bool one = dot(edge.normals[0], l) < 0, other = dot(edge.normals[1], l) < 0;
        if (!has_contours_) return EdgeView::Towards;
        if (one != other) return EdgeView::Horizon;
        return one && is_body_ ? EdgeView::Away : EdgeView::Towards;
    }

private:
    const LocalEye& eye_;
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
        const auto traced = trace(data, float(style.crease_angle));
        const float shortest = Thresholds(style).shortest_line;
        const EdgeFacing facing(eye, style, data.is_body && !may_be_within(eye));
        for (std::size_t i = 0; i < traced->lines.lines.size(); ++i)
            if (is_drawn(traced->nets[i], shortest))
                append_line(*traced, traced->lines.lines[i], facing, lines);
    }

    std::shared_ptr<const LineSet> whole(const ExtractorData& data,
                                         const LineStyle& style) const override {
        const auto traced = trace(data, float(style.crease_angle));
        const float shortest = Thresholds(style).shortest_line;
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!whole_ || whole_->of != traced || whole_->shortest != shortest)
            whole_ =
                std::make_shared<const Whole>(Whole{traced, shortest, drawn(*traced, shortest)});
        return {whole_, &whole_->lines};
    }

private:
    /// What is drawn, wherever the eye is.
    struct Whole {
        std::shared_ptr<const TracedCreases> of;
        float shortest;
        LineSet lines;
    };

    static bool is_drawn(const TracedCreases::Net& net, float shortest) {
        const bool is_ragged = net.pieces < kPiecesOfAFault * net.faults &&
                               net.length < kRaggedPiece * float(net.pieces);
        return !is_ragged && (net.pieces >= kFewPieces || net.length >= kShortNet * shortest);
    }

    static LineSet drawn(const TracedCreases& traced, float shortest) {
        LineSet lines;
        for (std::size_t i = 0; i < traced.lines.lines.size(); ++i) {
            const Polyline& line = traced.lines.lines[i];
            if (is_drawn(traced.nets[i], shortest))
                append_part(traced, line, 0, line.count - 1, lines);
        }
        return lines;
    }

    /// Those of the last angle that was asked for are kept. Thread-safe.
    std::shared_ptr<const TracedCreases> trace(const ExtractorData& data, float least_angle) const {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!traced_ || traced_->least_angle != least_angle) {
            traced_ = std::make_shared<const TracedCreases>(
                trace_creases(data, edges(data, least_angle), least_angle));
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
    mutable std::shared_ptr<const TracedCreases> traced_;
    mutable std::shared_ptr<const Whole> whole_;
};

}  // namespace

const FixedKind creases = fixed_kind<Creases>(LineKind::Crease);

}  // namespace laplacian_lines
