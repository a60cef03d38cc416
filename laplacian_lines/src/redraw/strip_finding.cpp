// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/strip_finding.h"

#include <algorithm>

#include "system/simd_sets.h"
#include "system/thread_pool.h"

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

}  // namespace

void find_strips(const ExtractorData& data, const ExtractionTask& task, FoundStrips& found) {
    const ClusterStore store = data.store();
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

}  // namespace laplacian_lines
