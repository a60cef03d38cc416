// SPDX-License-Identifier: GPL-3.0-or-later
// A strip is the part of a line within a cluster:
//  1. Threads take chunks of clusters: those that face away are culled, strips of the others found
//     (simd/) and written to the thread's own memory.
//  2. Strips are joined in the order of the chunks, at the numbers of the edges where they leave
//     their clusters: the first to come waits there, the second takes it.
// Contours of coarse meshes are edges instead: each one between front and back is a strip.
#include "redraw/strips.h"

#include <algorithm>

#include "system/parallel.h"
#include "system/simd_sets.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr std::size_t kChunk = 4 * kFormGroup;  // clusters that a thread takes at a time

/// Makes place for so many strips and points and those of a batch, with some to spare.
void reserve(FindingThread& thread, unsigned kind, std::size_t strips, std::size_t points) {
    const auto grow = [](auto& array, std::size_t used, std::size_t batch) {
        if (array.size() < used + batch) array.resize(used + used / 2 + batch);
        return array.data();
    };
    thread.output[kind].strips = grow(thread.strips[kind], strips, kStripsOfBatch);
    thread.output[kind].points = grow(thread.points[kind], points, kPointsOfBatch);
}

bool is_wanted(const ExtractionTask& task, const StripPass& pass) {
    return std::any_of(task.kinds + pass.first, task.kinds + pass.first + pass.count,
                       [](const ExtractionTask::Wanted& kind) { return kind.lines; });
}

void find_chunk(const ClusterStore& store, std::size_t cluster_count, const ExtractionTask& task,
                std::size_t index, FindingThread& thread, ChunkOfStrips& chunk) {
    const std::size_t begin = index * kChunk, end = std::min(begin + kChunk, cluster_count);
    for (unsigned kind = 0; kind < kStripKindCount; ++kind)
        chunk.begin[kind] = thread.output[kind].strip_count;
    for (unsigned pass = 0; pass < kStripPassCount; ++pass) {
        const StripPass kinds = kStripPasses[pass];
        if (!is_wanted(task, kinds)) continue;
        const StripFunctions& functions = fastest<RedrawLoops>().passes[pass];
        const std::size_t kept = functions.cull(store, task, begin, end, thread.kept.data());
        for (std::size_t i = 0; i < kept; i += kBatch) {
            for (unsigned kind = kinds.first; kind < kinds.first + kinds.count; ++kind)
                reserve(thread, kind, thread.output[kind].strip_count,
                        thread.output[kind].point_count);
            functions.extract_strips(store, task, &thread.kept[i],
                                     std::min<std::size_t>(kBatch, kept - i), *thread.memory,
                                     thread.output + kinds.first);
        }
    }
    for (unsigned kind = 0; kind < kStripKindCount; ++kind)
        chunk.end[kind] = thread.output[kind].strip_count;
}

/// Gives each thread room for all that was found, since it may find any part of that next time:
/// redraws allocate nothing.
void even_out(const ExtractionTask& task, FoundStrips& found) {
    for (const StripPass& pass : kStripPasses)
        for (unsigned kind = pass.first; kind < pass.first + pass.count; ++kind) {
            if (!is_wanted(task, pass)) continue;
            std::size_t strips = 0, points = 0;
            for (const FindingThread& thread : found.threads) {
                strips += thread.output[kind].strip_count;
                points += thread.output[kind].point_count;
            }
            for (FindingThread& thread : found.threads)
                reserve(thread, kind, strips, points);
        }
}

constexpr std::uint32_t kStripsAhead = 8;  // whose places are asked for in advance

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
        if (waiting == kNoEnd) {
            waiting = end;
            continue;
        }
        join(waiting, end);
        waiting = kNoEnd;
    }
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
        thread.kept.resize(kChunk);
        for (StripOutput& output : thread.output)
            output.strip_count = output.point_count = 0;
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

void append_horizon(const EdgeHorizon& horizon, const LocalEye& eye, unsigned kind,
                    FoundStrips& found) {
    horizon.evaluate(eye.eye, eye.w, found.facing);
    const auto faces = [&](std::uint32_t triangle) { return found.facing[triangle] >= 0; };
    const bool is_outside = !may_be_within(eye);
    FindingThread& thread = found.threads[0];
    StripOutput& output = thread.output[kind];
    ChunkOfStrips chunk{};
    chunk.begin[kind] = output.strip_count;
    for (const EdgeHorizon::Edge& edge : horizon.edges) {
        if (faces(edge.triangles[0]) == (faces(edge.triangles[1]) != edge.is_reversed)) continue;
        reserve(thread, kind, output.strip_count, output.point_count);
        const auto [from, to] = edge.vertices;
        const Eigen::Vector3f ends[2] = {horizon.positions[from], horizon.positions[to]};
        const float length = length_of(ends[1] - ends[0]);
        output.strips[output.strip_count++] = {output.point_count, 2, {from, to}, length, 0, 0, 0};
        for (const Eigen::Vector3f& p : ends)
            output.points[output.point_count++] = {
                {p.x(), p.y(), p.z()}, 0, edge.is_hollow && is_outside ? -0.f : 0.f, 1};
    }
    chunk.end[kind] = output.strip_count;
    found.chunks.push_back(chunk);
}

void join_strips(const FoundStrips& found, unsigned kind, std::uint32_t place_count,
                 JoiningMemory& memory) {
    std::size_t strips = 0;
    for (const ChunkOfStrips& chunk : found.chunks)
        strips += chunk.end[kind] - chunk.begin[kind];
    memory.strips[kind].clear();
    if (strips == 0) return;
    memory.strips[kind].reserve(strips);
    memory.end_at_edge.assign(place_count, kNoEnd);
    std::uint32_t loop = kNoEnd;
    for (const ChunkOfStrips& chunk : found.chunks) {
        const StripOutput& output = found.threads[chunk.thread].output[kind];
        for (std::uint32_t i = chunk.begin[kind]; i < chunk.end[kind]; ++i) {
            const Strip& later = output.strips[std::min(i + kStripsAhead, chunk.end[kind] - 1)];
            for (const std::uint32_t edge : later.edges)  // asks for what lies anywhere
                if (edge < Strip::kContinued) __builtin_prefetch(&memory.end_at_edge[edge], 1);
            append(output.strips[i], output.points, memory.strips[kind], memory, loop);
        }
    }
}

}  // namespace laplacian_lines
