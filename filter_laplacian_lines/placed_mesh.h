// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

// Meshes and fields in world coordinates, where drawings are measured.

/// x' = factor · rotation · x; without the translation.
struct Similarity {
    Eigen::Matrix3d rotation;
    double factor;
};

/// None if the layer's transformation stretches, shears or reflects.
std::optional<Similarity> similarityOf(const Eigen::Matrix4d& layer);

/// Moves a layer's mesh into the world. Reflected faces keep their outside.
/// @throws laplacian_lines::Error(InvalidOption) if the transformation is singular
void place(const Eigen::Matrix4d& layer, laplacian_lines::TriangleMesh& mesh);

/// Transforms a field and its lengths, but drops curvature derivatives, whose frames do not follow.
void place(const Similarity& similarity, laplacian_lines::Field& field);
