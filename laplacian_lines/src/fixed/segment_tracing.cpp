// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/segment_tracing.h"

#include "fixed/line_smoothing.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

std::uint32_t crossing_at(const CrossingGraph& graph, std::uint32_t half) {
    const Segment& s = graph.segments[half / 2];
    return half % 2 == 0 ? s.begin : s.end;
}

void link_halves(const CrossingGraph& graph, TracingMemory& memory) {
    memory.linked_half.assign(2 * graph.segments.size(), kNone);
    memory.half_of_crossing.assign(graph.crossings.size(), kNone);
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
        } else if (memory.linked_half[first] != kNone) {  // a third segment: a junction
            memory.linked_half[memory.linked_half[first]] = kNone;
            memory.linked_half[first] = kNone;
        }
    }
}

class Tracer {
public:
    Tracer(const ExtractorData& data, const LineRules& rules, const CrossingGraph& graph,
           TracingMemory& memory, LineSet& lines)
        : data_(data), rules_(rules), graph_(graph), memory_(memory), lines_(lines) {}

    void trace_all() {
        link_halves(graph_, memory_);
        memory_.visited.assign(graph_.segments.size(), 0);
        // Begins before ends, so that lines keep the segments' direction; what is left are loops.
        for (std::uint32_t offset : {0u, 1u})
            for (std::uint32_t s = 0; s < graph_.segments.size(); ++s)
                if (memory_.linked_half[2 * s + offset] == kNone) trace(2 * s + offset);
        for (std::uint32_t s = 0; s < graph_.segments.size(); ++s)
            trace(2 * s);
    }

private:
    /// Follows the line that starts at `half` and keeps it if the rules accept it.
    void trace(std::uint32_t half) {
        if (memory_.visited[half / 2]) return;
        const std::uint32_t start = half;
        Polyline line;
        line.first = std::uint32_t(lines_.points.size());
        line.kind = rules_.kind;
        add_point(crossing_at(graph_, half), 0);
        for (;;) {
            const std::uint32_t s = half / 2;
            memory_.visited[s] = 1;
            add_segment(crossing_at(graph_, half), crossing_at(graph_, half ^ 1),
                        graph_.segments[s].slope, line);
            half = memory_.linked_half[half ^ 1];
            if (half == kNone || half == start) break;
        }
        line.closed = half == start;
        line.count = std::uint32_t(lines_.points.size()) - line.first;
        finish(line);
    }

    void add_point(std::uint32_t crossing, float slope) {
        const Crossing& c = graph_.crossings[crossing];
        lines_.points.push_back({c.position, slope, c.gradient, c.opacity});
    }

    void add_segment(std::uint32_t from, std::uint32_t to, float slope, Polyline& line) {
        lines_.points.back().weight += slope;
        add_point(to, slope);
        const Crossing &a = graph_.crossings[from], &b = graph_.crossings[to];
        const float length = (b.position - a.position).norm();
        line.length += length;
        line.strength += (a.gradient + b.gradient) / 2 * length;
        line.slope += slope * length;
    }

    void finish(Polyline& line) {
        line.slope = line.length > 0 ? line.slope / line.length : 0;
        if (!accepts(line)) {
            lines_.points.resize(line.first);
            return;
        }
        LinePoint* points = lines_.points.data() + line.first;
        for (std::uint32_t i = 0; i < line.count; ++i)
            points[i].weight = points[i].opacity = 1;
        smooth_positions(line, points, rules_.smoothing_passes);
        for (std::uint32_t i = 0; i < line.count; ++i)
            points[i].position =
                (data_.centre + data_.diagonal * points[i].position.cast<double>()).cast<float>();
        lines_.lines.push_back(line);
    }

    bool accepts(const Polyline& line) const {
        return line.length >= rules_.least_length && line.strength >= rules_.least_strength &&
               (!rules_.use_slope || line.slope >= rules_.line_slope);
    }

    const ExtractorData& data_;
    const LineRules& rules_;
    const CrossingGraph& graph_;
    TracingMemory& memory_;
    LineSet& lines_;
};

}  // namespace

void trace_polylines(const ExtractorData& data, const LineRules& rules, const CrossingGraph& graph,
                     TracingMemory& memory, LineSet& lines) {
    Tracer(data, rules, graph, memory, lines).trace_all();
}

}  // namespace laplacian_lines
