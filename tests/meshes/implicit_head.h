// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "marching_cubes.h"

namespace test_meshes {

/// Less than 0 inside of a smooth head, made of soft blobs and hollows: skull, jaw, neck, nose,
/// brows, eyes in their sockets, lips, ears. It looks along +z, y is up, and it is within 1.1 of
/// the origin along each axis.
double implicit_head(const Eigen::Vector3d& p);

/// In a volume of size³ voxels. Smooth: as exact as its voxels; terraced: from labels alone.
laplacian_lines::TriangleMesh smooth_head(int size);
laplacian_lines::TriangleMesh terraced_head(int size);

}  // namespace test_meshes
