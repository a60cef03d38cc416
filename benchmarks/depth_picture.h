// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "picture_camera.h"
#include "pixel_mask.h"

namespace benchmarks {

/// Which triangle is seen at the middle of each pixel, from either side. Camera and mesh have to
/// outlive it; all triangles of the mesh have to be usable.
class DepthPicture {
public:
    DepthPicture(const PictureCamera& camera, const laplacian_lines::TriangleMesh& mesh);

    int size() const { return camera_.size(); }
    bool is_surface(int x, int y) const { return triangle_at(x, y) >= 0; }
    /// -1 where there is none, and beside the picture.
    std::int32_t triangle_at(int x, int y) const;
    /// In mesh units, at the middle of a pixel; infinite where no surface is.
    double depth_at(int x, int y) const;
    /// Of the plane of a triangle at any place of the picture.
    double plane_depth(std::int32_t triangle, double column, double row) const;
    /// Unit normal of a triangle, turned towards the eye.
    Eigen::Vector3d normal_to_eye(std::int32_t triangle) const;

    /// The pixels of the surface beside one without: above, below, left or right.
    PixelMask outline() const;
    /// Both pixels where two neighbours show triangles whose planes, each continued to the other
    /// pixel, miss it by more than `depth`, in mesh units.
    PixelMask depth_jumps(double depth) const;
    /// Both pixels where the normals of two neighbours' triangles differ by more than that.
    PixelMask normal_jumps(double degrees) const;

private:
    void draw(std::int32_t triangle);
    template <class Differ>
    PixelMask jumps(Differ differ) const;
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(size()) + std::size_t(x);
    }

    const PictureCamera& camera_;
    const laplacian_lines::TriangleMesh& mesh_;
    std::vector<Eigen::Vector3d> places_;  // of the vertices: column, row, affine depth
    std::vector<std::int32_t> triangles_;  // by pixel
    std::vector<double> depths_;           // by pixel, affine
};

}  // namespace benchmarks
