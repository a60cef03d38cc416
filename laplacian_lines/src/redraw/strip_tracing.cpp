// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/strip_tracing.h"

namespace laplacian_lines {
namespace {

bool accepts(const LineRules& rules, const Polyline& line) {
    return line.length >= rules.least_length && line.strength >= rules.least_strength &&
           (!rules.use_slope || line.slope >= rules.line_slope);
}

class Tracer {
public:
    Tracer(const LineRules& rules, std::vector<JoinedStrip>& strips, TracedLines& traced)
        : rules_(rules), strips_(strips), traced_(traced) {}

    void trace_all() {
        // First points before last ones, so that lines keep the strips' direction; what is left
        // are closed lines.
        for (std::uint32_t side : {0u, 1u})
            for (std::uint32_t s = 0; s < strips_.size(); ++s)
                if (strips_[s].links[side] == JoinedStrip::kNone) trace(2 * s + side);
        for (std::uint32_t s = 0; s < strips_.size(); ++s)
            trace(2 * s);
    }

private:
    /// Follows the line that starts at an end of a strip, and keeps it if the rules accept it.
    void trace(std::uint32_t start) {
        if (strips_[start / 2].visited) return;
        TracedLines::Line line{{}, std::uint32_t(traced_.ends.size()), 0, &rules_, strips_.data()};
        Polyline& p = line.polyline;
        p.first = traced_.point_count;
        p.kind = rules_.kind;
        p.count = 1;
        std::uint32_t end = start;
        do {
            JoinedStrip& strip = strips_[end / 2];
            strip.visited = true;
            traced_.ends.push_back(end);
            p.count += strip.count - 1;
            p.length += strip.length;
            p.strength += strip.strength;
            p.slope += strip.slope;
            end = strip.links[~end & 1];
        } while (end != JoinedStrip::kNone && end != start);
        p.closed = end == start;
        p.slope = p.length > 0 ? p.slope / p.length : 0;
        line.end_count = std::uint32_t(traced_.ends.size()) - line.first_end;
        if (!accepts(rules_, p)) {
            traced_.ends.resize(line.first_end);
            return;
        }
        traced_.lines.push_back(line);
        traced_.point_count += p.count;
    }

    const LineRules& rules_;
    std::vector<JoinedStrip>& strips_;
    TracedLines& traced_;
};

}  // namespace

void trace_lines(const LineRules& rules, std::vector<JoinedStrip>& strips, TracedLines& traced) {
    Tracer(rules, strips, traced).trace_all();
}

}  // namespace laplacian_lines
