// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

// Meshes and fields as they stand in the world: drawings are measured there.

/// A transformation that keeps shapes, but for where it moves them: x' = factor · rotation · x.
struct Similarity {
    Eigen::Matrix3d rotation;
    double factor;
};

/// That of a layer's transformation; none if it stretches, shears or reflects.
std::optional<Similarity> similarityOf(const Eigen::Matrix4d& layer);

/// Moves the mesh of a layer to where it stands in the world. Faces keep their outside, also if
/// they are reflected.
/// @throws laplacian_lines::Error(InvalidOption) for a transformation that cannot be inverted.
void place(const Eigen::Matrix4d& layer, laplacian_lines::TriangleMesh& mesh);

/// Turns a field, and its lengths, into that of the placed mesh, but without curvature derivatives,
/// whose frames do not turn along.
void place(const Similarity& similarity, laplacian_lines::Field& field);
