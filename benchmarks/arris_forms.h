// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "line_scores.h"
#include "truth_options.h"

namespace benchmarks {

/// A form whose arrises are known.
struct ArrisForm {
    Truth truth;
    double diagonal;
    /// Of so many times the triangles of resolution 1.
    std::function<laplacian_lines::TriangleMesh(double resolution)> mesh;
};

/// Flaked stones, one a seed; `radius` is that of their arrises, % of D.
std::vector<ArrisForm> flaked_stones(double radius, const TruthOptions& options);
/// A machined part with fillets of this radius, % of D.
ArrisForm machined_part(double radius, const TruthOptions& options);

/// From all sides of a form.
extern const std::array<Eigen::Vector3d, 6> arris_eyes;

}  // namespace benchmarks
