// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/precompute_options.h"
#include "prepared_mesh.h"

namespace laplacian_lines {

/// √h of the whole mesh in local units: the option, or the automatic size.
double global_kernel_size(const PreparedMesh& mesh, const PrecomputeOptions& options);

/// √h(p) / √h for every vertex, [N]: 1 everywhere, or the local edge length in mean edges,
/// smoothed and clamped (see PrecomputeOptions::kernel_mode).
std::vector<float> relative_kernel_sizes(const PreparedMesh& mesh, KernelMode mode);

}  // namespace laplacian_lines
