// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

struct PictureOfMesh {
    laplacian_lines::View view;  ///< mesh coordinates
    Eigen::Matrix4d to_eye;      ///< mesh to eye coordinates
    Eigen::Matrix4d projection;  ///< of the whole picture
    double height = 0;           ///< pixels
};

/// Points of a surface, to measure its size in a picture.
class SurfaceSamples {
public:
    SurfaceSamples() = default;
    SurfaceSamples(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Field& field);

    /// The length of a pixel on the surface, mesh units: the geometric mean over what faces the
    /// eye, mainly in the picture's middle. Continuous in the camera. 0 if nothing is before the
    /// eye.
    double pixelSize(const PictureOfMesh& picture) const;

    std::size_t bytes() const;

private:
    using Rows = Eigen::Matrix<float, Eigen::Dynamic, 3>;
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();  ///< of the positions, mesh coordinates
    Rows positions_, normals_;
};
