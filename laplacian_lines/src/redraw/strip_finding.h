// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "clusters/extractor_data.h"
#include "redraw/simd/redraw_loops.h"

namespace laplacian_lines {

/// The strips of one kind that a thread found.
struct ThreadStrips {
    std::vector<Strip> strips;  // longer than what is in use, to keep resize() from clearing
    std::vector<StripPoint> points;
    std::uint32_t strip_count = 0, point_count = 0;
};

struct FindingThread {
    std::unique_ptr<SimdMemory> memory;
    std::vector<KeptCluster> kept;
    ThreadStrips strips[kStripKindCount];
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
};

/// Finds all strips of a view on several threads. What is found, and its order, does not depend on
/// their number.
void find_strips(const ExtractorData& data, const ExtractionTask& task, FoundStrips& found);

}  // namespace laplacian_lines
