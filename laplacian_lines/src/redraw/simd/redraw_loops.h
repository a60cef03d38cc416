// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "redraw/simd/simd_memory.h"

/// The inner loops of a redraw. Plain data only, see cluster_data.h.
namespace laplacian_lines {

/// The points of a line, a column for each number, on cache units; with a place before the first
/// and kColumnMargin places after the last. finish_line() may swap columns.
struct LineColumns {
    float *x, *y, *z;  ///< local
    float* gradient;
    float* weight;   ///< of the segment that ends here, the slope
    float* opacity;  ///< of the crossing alone
    float* spare;
};
constexpr unsigned kColumnMargin = 31;

/// What rules on whole lines look at.
struct LineSums {
    std::uint32_t count;  ///< points
    bool closed;
    /// Segments of the slope kExactSegment, in kinds that do not use slopes, stay where they are.
    bool has_exact;
    float length, strength, slope;
};

/// How the kinds of one of kStripPasses are found.
struct StripFunctions {
    /// Writes to `kept` those of the clusters [begin, end), a multiple of kFormGroup apart from the
    /// end of all, that can hold a line, and returns their number.
    std::size_t (*cull)(const ClusterStore&, const ExtractionTask&, std::size_t begin,
                        std::size_t end, KeptCluster* kept);
    /// Finds the strips of up to kBatch clusters; an output for each kind of the pass.
    void (*extract_strips)(const ClusterStore&, const ExtractionTask&, const KeptCluster* clusters,
                           std::size_t count, SimdMemory&, StripOutput* outputs);
};

/// See simd_sets.h.
struct RedrawLoops {
    StripFunctions passes[kStripPassCount];
    /// Appends the points of a strip to a line's columns at a place, as `weight` their slopes.
    /// Reads up to kPointMargin points more.
    void (*append_points)(const StripPoint* points, std::uint32_t count, const LineColumns& columns,
                          std::size_t place);
    /// Weights, opacities and smoothed positions of a line, written as LinePoint's six floats in
    /// mesh coordinates. Overwrites the columns.
    void (*finish_line)(const LineRules& rules, const LineSums& line, LineColumns& columns,
                        const double centre[3], double diagonal, float* points);
};

}  // namespace laplacian_lines
