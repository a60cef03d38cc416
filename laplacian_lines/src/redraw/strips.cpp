// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/strips.h"

#include <algorithm>

#include "system/parallel.h"
#include "system/simd_sets.h"

namespace laplacian_lines {

namespace {

constexpr std::size_t kChunk = 4 * kFormGroup;  // clusters that a thread takes at a time

/// Makes place for so many strips and points and those of a batch, with some to spare.
void reserve(ThreadStrips& s, std::size_t strips, std::size_t points) {
    if (s.strips.size() < strips + kStripsOfBatch)
        s.strips.resize(strips + strips / 2 + kStripsOfBatch);
    if (s.points.size() < points + kPointsOfBatch + kPointMargin)
        s.points.resize(points + points / 2 + kPointsOfBatch + kPointMargin);
}

void find_batch(const ClusterStore& store, const ExtractionTask& task, unsigned pass,
                const KeptCluster* clusters, std::size_t count, FindingThread& thread) {
    const StripPass kinds = kStripPasses[pass];
    StripOutput outputs[kMostKindsOfPass];
    for (unsigned kind = 0; kind < kinds.count; ++kind) {
        ThreadStrips& s = thread.strips[kinds.first + kind];
        reserve(s, s.strip_count, s.point_count);
        outputs[kind] = {s.strips.data(), s.points.data(), s.strip_count, s.point_count};
    }
    fastest<RedrawLoops>().passes[pass].extract_strips(store, task, clusters, count, *thread.memory,
                                                       outputs);
    for (unsigned kind = 0; kind < kinds.count; ++kind) {
        thread.strips[kinds.first + kind].strip_count = outputs[kind].strip_count;
        thread.strips[kinds.first + kind].point_count = outputs[kind].point_count;
    }
}

bool is_wanted(const ExtractionTask& task, const StripPass& pass) {
    return std::any_of(task.kinds + pass.first, task.kinds + pass.first + pass.count,
                       [](const ExtractionTask::Wanted& kind) { return kind.lines; });
}

void find_chunk(const ClusterStore& store, std::size_t cluster_count, const ExtractionTask& task,
                std::size_t index, FindingThread& thread, ChunkOfStrips& chunk) {
    const std::size_t begin = index * kChunk, end = std::min(begin + kChunk, cluster_count);
    for (unsigned kind = 0; kind < kStripKindCount; ++kind)
        chunk.begin[kind] = thread.strips[kind].strip_count;
    for (unsigned pass = 0; pass < kStripPassCount; ++pass) {
        if (!is_wanted(task, kStripPasses[pass])) continue;
        const std::size_t kept =
            fastest<RedrawLoops>().passes[pass].cull(store, task, begin, end, thread.kept.data());
        for (std::size_t i = 0; i < kept; i += kBatch)
            find_batch(store, task, pass, &thread.kept[i], std::min<std::size_t>(kBatch, kept - i),
                       thread);
    }
    for (unsigned kind = 0; kind < kStripKindCount; ++kind)
        chunk.end[kind] = thread.strips[kind].strip_count;
}

void even_out(unsigned kind, FoundStrips& found) {
    std::size_t strips = 0, points = 0;
    for (const FindingThread& thread : found.threads) {
        strips += thread.strips[kind].strip_count;
        points += thread.strips[kind].point_count;
    }
    for (FindingThread& thread : found.threads)
        reserve(thread.strips[kind], strips, points);
}

/// Any thread may find any part of the strips next time, or its first part; then none of them has
/// to allocate, for kinds that share a pass with a wanted one either.
void even_out(const ExtractionTask& task, FoundStrips& found) {
    for (const StripPass& pass : kStripPasses)
        if (is_wanted(task, pass))
            for (unsigned kind = pass.first; kind < pass.first + pass.count; ++kind)
                even_out(kind, found);
}

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

void find_strips(const ExtractorData& data, const LaplacianForms& laplacians,
                 const ExtractionTask& task, FoundStrips& found) {
    const ClusterStore store = data.store(laplacians);
    const std::size_t chunks = (data.clusters.size() + kChunk - 1) / kChunk;
    const unsigned workers = workers_for(chunks);
    if (found.threads.size() < workers) found.threads.resize(workers);
    found.chunks.resize(chunks);
    for (FindingThread& thread : found.threads) {
        if (!thread.memory) thread.memory = std::make_unique<SimdMemory>();
        thread.kept.resize(kChunk + 1);
        for (ThreadStrips& s : thread.strips)
            s.strip_count = s.point_count = 0;
    }
    share(chunks, workers, [&](unsigned worker, Blocks& shared) {
        for (std::size_t i; shared.take(i);) {
            found.chunks[i].thread = worker;
            find_chunk(store, data.clusters.size(), task, i, found.threads[worker],
                       found.chunks[i]);
        }
    });
    even_out(task, found);
}

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
