// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "meshlab_host/camera.h"

namespace meshlab_host {

/// Transforms a layer's mesh. Reflected faces keep their outside.
/// @throws laplacian_lines::Error(InvalidOption) if the transformation is singular
void apply_transform(const Eigen::Matrix4d& layer, laplacian_lines::TriangleMesh& mesh);

/// Transforms a field and its scale, but drops S̄ and C, whose frames depend on the normal's
/// coordinates. The report stays that of the mesh as it was.
void apply_transform(const Similarity& similarity, laplacian_lines::Field& field);

/// Transforms a mesh and its field, if it has one. A field that the transformation stretches or
/// reflects is recomputed with its options.
/// @throws laplacian_lines::Error as the above and precompute()
void apply_transform(const Eigen::Matrix4d& layer, laplacian_lines::PrecomputeOptions options,
                     laplacian_lines::TriangleMesh& mesh,
                     std::optional<laplacian_lines::Field>& field,
                     const laplacian_lines::Progress& progress);

}  // namespace meshlab_host
