// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/precompute_options.h"
#include "mesh/vertex_ranges.h"

namespace laplacian_lines {

/// √h of the whole mesh in local units: the option, or the automatic size.
double global_kernel_size(const PreparedMesh& mesh, const PrecomputeOptions& options);

/// √h(p) / √h for every vertex, [N]: 1 everywhere, or the local edge length in mean edges,
/// smoothed and clamped (see PrecomputeOptions::kernel_mode).
std::vector<float> relative_kernel_sizes(const PreparedMesh& mesh, const VertexRanges& ranges,
                                         KernelMode mode, const StageProgress& stage);

}  // namespace laplacian_lines
