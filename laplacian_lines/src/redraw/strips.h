// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "clusters/extractor_data.h"
#include "redraw/simd/redraw_loops.h"
#include "system/chains.h"

namespace laplacian_lines {

/// What a thread finds, by kind.
struct FindingThread {
    std::unique_ptr<SimdMemory> memory;
    std::vector<KeptCluster> kept;
    std::vector<Strip> strips[kStripKindCount];  ///< longer than what is in use, see `output`
    std::vector<StripPoint> points[kStripKindCount];
    StripOutput output[kStripKindCount];
};

/// The strips of successive clusters, all found by one thread.
struct ChunkOfStrips {
    std::uint32_t thread;
    std::uint32_t begin[kStripKindCount], end[kStripKindCount];
};

/// Strips in the order of the clusters: chunk after chunk. Keeps its memory.
struct FoundStrips {
    std::vector<FindingThread> threads;
    std::vector<ChunkOfStrips> chunks;
    std::vector<float> facing;  ///< of the horizon's triangles
};

/// Finds all strips of a view on several threads. What is found, and its order, does not depend on
/// their number.
void find_strips(const ExtractorData& data, const ExtractionTask& task, FoundStrips& found);

/// Appends the edges of the horizon: a strip of a kind for each, that ends at vertices instead of
/// edges. Both points of a hollow one have -0 as gradient if its body hides it: from outside.
void append_horizon(const EdgeHorizon& horizon, const LocalEye& eye, unsigned kind,
                    FoundStrips& found);

/// A strip and what goes on at its ends, see chains.h.
struct JoinedStrip {
    const StripPoint* points;
    std::uint32_t count;
    float length, strength, slope, concave;
    bool visited = false;                       ///< by trace_lines()
    std::uint32_t links[2] = {kNoEnd, kNoEnd};  ///< the end that goes on
};

struct JoiningMemory {
    std::vector<JoinedStrip> strips[kStripKindCount];
    std::vector<std::uint32_t> end_at_edge;  ///< the end that waits there, or kNoEnd
};

/// Replaces memory.strips[kind] by the strips of that kind, joined where two of them end at an
/// edge, or those of append_horizon() at a vertex. `place_count`: how many such edges or vertices
/// there are.
void join_strips(const FoundStrips& found, unsigned kind, std::uint32_t place_count,
                 JoiningMemory& memory);

}  // namespace laplacian_lines
