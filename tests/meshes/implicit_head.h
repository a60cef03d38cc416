// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// Values of a cube's voxels, [size³], x first; inside is below 0.
struct Volume {
    int size = 0;
    double half_width = 1;  ///< the outermost voxels are that far from the origin along the axes
    std::vector<float> values;

    std::size_t index(const Eigen::Vector3i& voxel) const;
    Eigen::Vector3d place(const Eigen::Vector3d& voxel) const;
};

Volume sampled(const std::function<double(const Eigen::Vector3d&)>& value, int size,
               double half_width);

/// Keeps only which voxels are inside.
Volume labels_of(const Volume& volume);

/// Facing outwards: polygons around the inside corners of each cell of eight voxels, with vertices
/// where values change sign on its edges, interpolated linearly (labels: halfway). Inside corners
/// opposite in a face are separate. W. Lorensen, H. Cline, "Marching Cubes", SIGGRAPH 1987, but
/// polygons are followed from face to face instead of a table. The outermost voxels have to be
/// outside.
laplacian_lines::TriangleMesh marching_cubes(const Volume& volume);

/// Below 0 inside a head of soft blobs and hollows: skull, jaw, neck, nose, brows, eyes, lips,
/// ears. It looks along +z, y is up; within 1.1 of the origin along each axis.
double implicit_head(const Eigen::Vector3d& p);

/// From size³ voxels. Smooth: exact values; terraced: labels alone.
laplacian_lines::TriangleMesh smooth_head(int size);
laplacian_lines::TriangleMesh terraced_head(int size);

}  // namespace test_meshes
