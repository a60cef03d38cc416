// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/strip_tracing.h"

#include <algorithm>
#include <limits>

#include "rules/line_acceptance.h"
#include "system/chains.h"

namespace laplacian_lines {
namespace {

constexpr float kLargestSlope = std::numeric_limits<float>::max();

class StripTracer {
public:
    StripTracer(const LineRules& rules, std::vector<JoinedStrip>& strips, TracedLines& traced)
        : rules_(rules), strips_(strips), traced_(traced) {}

    void trace_all() {
        for_each_chain(
            std::uint32_t(strips_.size()), [this](std::uint32_t end) { return link(end); },
            [this](std::uint32_t end) { trace(end); });
    }

private:
    std::uint32_t link(std::uint32_t end) const { return strips_[end / 2].links[end % 2]; }

    /// Follows the line that starts at an end of a strip, and keeps it if the rules accept it.
    void trace(std::uint32_t start) {
        if (strips_[start / 2].visited) return;
        TracedLines::Line line{
            {}, std::uint32_t(traced_.ends.size()), 0, false, &rules_, strips_.data()};
        Polyline& p = line.polyline;
        p.first = traced_.point_count;
        p.kind = rules_.kind;
        p.count = 1;
        p.closed = follow_chain(
            start, [this](std::uint32_t end) { return link(end); },
            [&](std::uint32_t end) {
                JoinedStrip& strip = strips_[end / 2];
                strip.visited = true;
                line.has_exact |= strip.exact;
                traced_.ends.push_back(end);
                p.count += strip.count - 1;
                p.length += strip.length;
                p.strength += strip.strength;
                p.slope += strip.slope;
            });
        // fields that are made up have lines of hardly any length
        p.slope = p.length > 0 ? std::min(p.slope / p.length, kLargestSlope) : 0;
        line.end_count = std::uint32_t(traced_.ends.size()) - line.first_end;
        if (rules_.whole) {
            traced_.whole.push_back(line);
            return;
        }
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
    StripTracer(rules, strips, traced).trace_all();
}

}  // namespace laplacian_lines
