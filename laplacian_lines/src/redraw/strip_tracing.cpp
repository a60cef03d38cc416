// SPDX-License-Identifier: GPL-3.0-or-later
// Joined strips are lines: open ones are followed from an end, then closed ones from any strip, and
// kept if the rules accept them. Lines that are tested as a whole are followed to collect the means
// of their pieces first; the parts that LinePartFinder finds are then kept likewise.
#include "redraw/strip_tracing.h"

#include <algorithm>
#include <limits>

#include "system/chains.h"

namespace laplacian_lines {
namespace {

constexpr float kLargestSlope = std::numeric_limits<float>::max();

class StripTracer {
public:
    StripTracer(const LineRules& rules, std::vector<JoinedStrip>& strips, PartMemory& memory,
                TracedLines& traced)
        : rules_(rules), strips_(strips), memory_(memory), traced_(traced) {}

    void trace_all() {
        for_each_chain(
            std::uint32_t(strips_.size()), [this](std::uint32_t end) { return link(end); },
            [this](std::uint32_t end) {
                if (strips_[end / 2].visited) return;
                if (rules_.whole)
                    trace_parts(end);
                else
                    trace(end);
            });
    }

private:
    std::uint32_t link(std::uint32_t end) const { return strips_[end / 2].links[end % 2]; }

    template <class Enter>
    bool follow(std::uint32_t start, const Enter& enter) {
        return follow_chain(
            start, [this](std::uint32_t end) { return link(end); },
            [&](std::uint32_t end) {
                strips_[end / 2].visited = true;
                enter(end);
            });
    }

    TracedLines::Line begin_line() const {
        TracedLines::Line line{
            {}, std::uint32_t(traced_.ends.size()), 0, 0, &rules_, strips_.data()};
        line.polyline.first = traced_.point_count;
        line.polyline.kind = rules_.kind;
        line.polyline.count = 1;
        return line;
    }

    void enter(std::uint32_t end, TracedLines::Line& line) {
        const JoinedStrip& strip = strips_[end / 2];
        traced_.ends.push_back(end);
        Polyline& p = line.polyline;
        p.count += strip.count - 1;
        p.length += strip.length;
        p.strength += strip.strength;
        p.slope += strip.slope;
    }

    /// Keeps the line if the rules accept it.
    void end_line(TracedLines::Line& line) {
        Polyline& p = line.polyline;
        // synthetic fields have lines of hardly any length
        p.slope = p.length > 0 ? std::min(p.slope / p.length, kLargestSlope) : 0;
        line.end_count = std::uint32_t(traced_.ends.size()) - line.first_end;
        if (!accepts(rules_, p)) {
            traced_.ends.resize(line.first_end);
            return;
        }
        traced_.lines.push_back(line);
        traced_.point_count += p.count;
    }

    /// Follows the line that starts at an end of a strip.
    void trace(std::uint32_t start) {
        TracedLines::Line line = begin_line();
        line.polyline.closed = follow(start, [&](std::uint32_t end) { enter(end, line); });
        end_line(line);
    }

    void trace_parts(std::uint32_t start) {
        memory_.ends.clear();
        memory_.pieces.clear();
        const bool closed = follow(start, [&](std::uint32_t end) {
            const JoinedStrip& strip = strips_[end / 2];
            memory_.ends.push_back(end);
            memory_.pieces.push_back({strip.length, strip.slope, strip.strength, strip.concave});
        });
        memory_.finder.find(rules_, memory_.pieces, closed);
        for (const LinePart& part : memory_.finder.parts())
            add_part(part);
    }

    void add_part(const LinePart& part) {
        const std::size_t pieces = memory_.ends.size();
        TracedLines::Line line = begin_line();
        line.polyline.closed = part.closed;
        line.first_knot = std::uint32_t(traced_.knots.size());
        for (std::size_t i = part.begin; i < part.begin + part.count; ++i)
            enter(memory_.ends[i % pieces], line);
        end_line(line);
        if (traced_.ends.size() == line.first_end) return;
        for (std::size_t i = part.begin; i <= part.begin + part.count; ++i) {
            const std::size_t knot = i > pieces ? i - pieces : i;
            traced_.knots.push_back({memory_.finder.slope(knot), memory_.finder.opacity(knot)});
        }
    }

    const LineRules& rules_;
    std::vector<JoinedStrip>& strips_;
    PartMemory& memory_;
    TracedLines& traced_;
};

}  // namespace

void trace_lines(const LineRules& rules, std::vector<JoinedStrip>& strips, PartMemory& memory,
                 TracedLines& traced) {
    StripTracer(rules, strips, memory, traced).trace_all();
}

}  // namespace laplacian_lines
