// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace test_meshes {

/// Values at the voxels of a cube, [size³], x first; less than 0 is inside.
struct Volume {
    int size = 0;
    double half_width = 1;  ///< the outermost voxels are that far from the origin along the axes
    std::vector<float> values;

    std::size_t index(const Eigen::Vector3i& voxel) const;
    Eigen::Vector3d place(const Eigen::Vector3d& voxel) const;
};

Volume sampled(const std::function<double(const Eigen::Vector3d&)>& value, int size,
               double half_width);

/// A segmented volume: nothing is left but which voxels are inside.
Volume labels_of(const Volume& volume);

/// The surface between inside and outside, facing outwards: in each cell of eight voxels the
/// polygons around corners that are inside, their vertices on the edges of the cell where values
/// change signs, interpolated linearly (labels: halfway). Inside corners that are opposite in a
/// face of a cell are parted. W. Lorensen, H. Cline, "Marching Cubes", SIGGRAPH 1987, without the
/// table of cases: polygons are followed from face to face. Outermost voxels have to be outside.
laplacian_lines::TriangleMesh marching_cubes(const Volume& volume);

/// Less than 0 inside of a smooth head, made of soft blobs and hollows: skull, jaw, neck, nose,
/// brows, eyes in their sockets, lips, ears. It looks along +z, y is up, and it is within 1.1 of
/// the origin along each axis.
double implicit_head(const Eigen::Vector3d& p);

/// In a volume of size³ voxels. Smooth: as exact as its voxels; terraced: from labels alone.
laplacian_lines::TriangleMesh smooth_head(int size);
laplacian_lines::TriangleMesh terraced_head(int size);

}  // namespace test_meshes
