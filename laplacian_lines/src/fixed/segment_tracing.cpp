// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/segment_tracing.h"

#include "fixed/line_smoothing.h"
#include "rules/line_acceptance.h"
#include "system/chains.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

class SegmentTracer {
public:
    SegmentTracer(const ExtractorData& data, const LineRules& rules, const CrossingGraph& graph,
                  TracingMemory& memory, LineSet& lines)
        : data_(data), rules_(rules), graph_(graph), memory_(memory), lines_(lines) {}

    void trace_all() {
        link_halves(graph_, memory_);
        memory_.visited.assign(graph_.segments.size(), 0);
        for_each_chain(
            std::uint32_t(graph_.segments.size()),
            [this](std::uint32_t half) { return memory_.linked_half[half]; },
            [this](std::uint32_t half) { trace(half); });
    }

private:
    /// From `half`; keeps the line if the rules accept it.
    void trace(std::uint32_t half) {
        if (memory_.visited[half / 2]) return;
        Polyline line;
        line.first = std::uint32_t(lines_.points.size());
        line.kind = rules_.kind;
        add_point(crossing_at(graph_, half));
        line.closed = follow_chain(
            half, [this](std::uint32_t end) { return memory_.linked_half[end]; },
            [&](std::uint32_t end) {
                memory_.visited[end / 2] = 1;
                add_segment(crossing_at(graph_, end), crossing_at(graph_, end ^ 1), line);
            });
        line.count = std::uint32_t(lines_.points.size()) - line.first;
        finish(line);
    }

    void add_point(std::uint32_t crossing) {
        const Crossing& c = graph_.crossings[crossing];
        lines_.points.push_back({c.position, 1, c.gradient, 1});
    }

    void add_segment(std::uint32_t from, std::uint32_t to, Polyline& line) {
        add_point(to);
        const Crossing &a = graph_.crossings[from], &b = graph_.crossings[to];
        const float length = length_of(b.position - a.position);
        line.length += length;
        line.strength += (a.gradient + b.gradient) / 2 * length;
    }

    void finish(Polyline& line) {
        if (!accepts(rules_, line)) {
            lines_.points.resize(line.first);
            return;
        }
        LinePoint* points = lines_.points.data() + line.first;
        smooth_positions(line, points, rules_.smoothing_passes);
        for (std::uint32_t i = 0; i < line.count; ++i)
            points[i].position =
                (data_.centre - data_.origin + data_.diagonal * points[i].position.cast<double>())
                    .cast<float>();
        lines_.lines.push_back(line);
    }

    const ExtractorData& data_;
    const LineRules& rules_;
    const CrossingGraph& graph_;
    TracingMemory& memory_;
    LineSet& lines_;
};

}  // namespace

void link_halves(const CrossingGraph& graph, TracingMemory& memory) {
    memory.linked_half.assign(2 * graph.segments.size(), kNoEnd);
    memory.half_of_crossing.assign(graph.crossings.size(), kNoEnd);
    memory.degree.assign(graph.crossings.size(), 0);
    for (std::uint32_t half = 0; half < memory.linked_half.size(); ++half) {
        const std::uint32_t c = crossing_at(graph, half);
        std::uint8_t& degree = memory.degree[c];
        if (degree < 3) ++degree;
        std::uint32_t& first = memory.half_of_crossing[c];
        if (degree == 1) {
            first = half;
        } else if (degree == 2) {
            memory.linked_half[half] = first;
            memory.linked_half[first] = half;
        } else if (memory.linked_half[first] != kNoEnd) {  // a third segment: a junction
            memory.linked_half[memory.linked_half[first]] = kNoEnd;
            memory.linked_half[first] = kNoEnd;
        }
    }
}

void trace_segments(const ExtractorData& data, const LineRules& rules, const CrossingGraph& graph,
                    TracingMemory& memory, LineSet& lines) {
    SegmentTracer(data, rules, graph, memory, lines).trace_all();
}

}  // namespace laplacian_lines
