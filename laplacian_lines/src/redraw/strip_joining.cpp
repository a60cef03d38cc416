// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/strip_joining.h"

#include <algorithm>

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kStripsAhead = 8;

/// Appends a strip and joins it to those that are there. `loop`: the end where the last closed line
/// began.
void append(const Strip& strip, const StripPoint* points, std::vector<JoinedStrip>& strips,
            JoiningMemory& memory, std::uint32_t& loop) {
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        strips[a / 2].links[a % 2] = b;
        strips[b / 2].links[b % 2] = a;
    };
    const std::uint32_t first_end = 2 * std::uint32_t(strips.size());
    strips.push_back({points + strip.first_point, strip.point_count, strip.length, strip.strength,
                      strip.slope, strip.concave});
    for (std::uint32_t side : {0u, 1u}) {
        const std::uint32_t edge = strip.edges[side], end = first_end + side;
        if (edge == Strip::kNoEdge) continue;
        if (edge == Strip::kClosed) {
            if (side == 0) loop = end;
            if (side == 1) join(loop, end);
            continue;
        }
        if (edge == Strip::kContinued) {
            strips.back().links[side] = side == 0 ? first_end - 1 : first_end + 2;
            continue;
        }
        std::uint32_t& waiting = memory.end_at_edge[edge];
        if (waiting < memory.first_end) {
            waiting = memory.first_end + end;
            continue;
        }
        join(waiting - memory.first_end, end);
        waiting = 0;
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
    std::uint32_t ends = 0;
    for (const ChunkOfStrips& chunk : found.chunks)
        ends += 2 * (chunk.end[kind] - chunk.begin[kind]);
    if (memory.end_at_edge.size() < border_edge_count || memory.next_end > kNoEnd - ends) {
        memory.end_at_edge.assign(border_edge_count, 0);
        memory.next_end = 1;
    }
    memory.first_end = memory.next_end;
    memory.next_end += ends;
    memory.strips[kind].clear();
    memory.strips[kind].reserve(ends / 2);
    std::uint32_t loop = kNoEnd;
    for_each_strip(found, kind, memory.end_at_edge,
                   [&](const Strip& strip, const StripPoint* points) {
                       append(strip, points, memory.strips[kind], memory, loop);
                   });
}

void find_open_ends(const FoundStrips& found, unsigned kind, JoiningMemory& memory) {
    memory.open_ends.clear();
    std::uint32_t end = 0;
    for_each_strip(found, kind, memory.end_at_edge, [&](const Strip& strip, const StripPoint*) {
        const JoinedStrip& joined = memory.strips[kind][end / 2];
        for (unsigned side : {0u, 1u})
            if (joined.links[side] == kNoEnd && strip.edges[side] < Strip::kContinued)
                memory.open_ends.push_back({strip.edges[side], end + side});
        end += 2;
    });
}

}  // namespace laplacian_lines
