// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/strip_joining.h"

#include <algorithm>

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kStripsAhead = 8;

/// Appends a strip and joins it to those that are there.
void append(const Strip& strip, const StripPoint* points, std::vector<JoinedStrip>& strips,
            std::vector<std::uint32_t>& end_at_edge) {
    const std::uint32_t first_end = 2 * std::uint32_t(strips.size());
    strips.push_back({points + strip.first_point,
                      strip.point_count,
                      {kNoEnd, kNoEnd},
                      strip.length,
                      strip.strength,
                      strip.slope,
                      strip.concave,
                      false,
                      false});
    for (std::uint32_t side : {0u, 1u}) {
        const std::uint32_t edge = strip.edges[side], end = first_end + side;
        if (edge == Strip::kNoEdge) continue;
        if (edge == Strip::kClosed) {
            strips.back().links[side] = end ^ 1;
            continue;
        }
        if (edge == Strip::kContinued) {
            if (side == 0) strips.back().links[0] = first_end - 1;
            if (side == 1) strips.back().links[1] = first_end + 2;
            continue;
        }
        std::uint32_t& waiting = end_at_edge[edge];
        if (waiting == kNoEnd) {
            waiting = end;
            continue;
        }
        strips.back().links[side] = waiting;
        strips[waiting / 2].links[waiting % 2] = end;
        waiting = kNoEnd;
    }
}

/// Asks for what lies at the edges of later strips, which are anywhere.
template <class Visit>
void for_each_strip(const FoundStrips& found, unsigned kind,
                    const std::vector<std::uint32_t>& end_at_edge, Visit visit) {
    for (const ChunkOfStrips& chunk : found.chunks) {
        const ThreadStrips& thread = found.threads[chunk.thread].strips[kind];
        for (std::uint32_t i = chunk.begin[kind]; i < chunk.end[kind]; ++i) {
            const Strip& later = thread.strips[std::min(i + kStripsAhead, chunk.end[kind] - 1)];
            for (const std::uint32_t edge : later.edges)
                if (edge < Strip::kContinued) __builtin_prefetch(&end_at_edge[edge], 1);
            visit(thread.strips[i], thread.points.data());
        }
    }
}

}  // namespace

void join_strips(const FoundStrips& found, unsigned kind, std::uint32_t border_edge_count,
                 JoiningMemory& memory) {
    if (memory.in_use || memory.end_at_edge.size() < border_edge_count)
        memory.end_at_edge.assign(border_edge_count, kNoEnd);
    memory.in_use = true;
    memory.strips[kind].clear();
    for_each_strip(found, kind, memory.end_at_edge,
                   [&](const Strip& strip, const StripPoint* points) {
                       append(strip, points, memory.strips[kind], memory.end_at_edge);
                   });
    memory.open_ends.clear();
    std::uint32_t end = 0;
    for_each_strip(found, kind, memory.end_at_edge, [&](const Strip& strip, const StripPoint*) {
        const JoinedStrip& joined = memory.strips[kind][end / 2];
        for (unsigned side : {0u, 1u}) {  // what still waits
            const std::uint32_t edge = strip.edges[side];
            if (joined.links[side] != kNoEnd || edge >= Strip::kContinued) continue;
            memory.end_at_edge[edge] = kNoEnd;
            memory.open_ends.push_back({edge, end + side});
        }
        end += 2;
    });
    memory.in_use = false;
}

}  // namespace laplacian_lines
