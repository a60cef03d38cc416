// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"
#include "speed_report.h"

namespace benchmarks {

/// Adds the times of precompute() on one and two threads, the memory it takes at the most, and the
/// time of a plain sum over cells for Δn alone. `kernel_size` is √h in mesh units.
void add_precompute(const laplacian_lines::TriangleMesh& mesh, double kernel_size,
                    MeshFigures& figures);

}  // namespace benchmarks
