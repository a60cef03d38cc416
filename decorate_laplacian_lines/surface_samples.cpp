// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_samples.h"

#include <Eigen/Geometry>
#include <cmath>

#include "meshlab_host/camera.h"

namespace {

constexpr std::size_t most_samples = 8192;
constexpr float least_depth = 1e-15f;  // whose square is a float
constexpr float turned_away = 0.01f;   // what counts of the surface where it does not face the eye

}  // namespace

SurfaceSamples::SurfaceSamples(const laplacian_lines::TriangleMesh& mesh,
                               const laplacian_lines::Field& field) {
    // Odd: no common divisor with the rows of regular meshes.
    const std::size_t step = mesh.positions.size() / most_samples | 1;
    std::size_t count = 0;
    const auto is_used = [&](std::size_t v) { return !field.normals[v].isZero(); };
    for (std::size_t v = 0; v < mesh.positions.size(); v += step)
        count += is_used(v);
    positions_.resize(Eigen::Index(count), 3);
    normals_.resize(Eigen::Index(count), 3);
    Eigen::Index row = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); v += step) {
        if (!is_used(v)) continue;
        if (row == 0) origin_ = mesh.positions[v];
        positions_.row(row) = (mesh.positions[v] - origin_).cast<float>();
        normals_.row(row++) = field.normals[v];
    }
}

double SurfaceSamples::pixelSize(const PictureOfMesh& picture) const {
    using Column = Eigen::ArrayXf;
    const Eigen::Matrix4d to_clip = picture.projection * picture.to_eye;
    const auto along = [&](const Eigen::Vector4d& form) -> Column {
        return (positions_ * form.head<3>().cast<float>()).array() +
               float(form.dot(origin_.homogeneous()));
    };
    const Column w_of_clip = along(to_clip.row(3)), depth = w_of_clip.max(least_depth);
    const Column x = along(to_clip.row(0)), y = along(to_clip.row(1));
    // n·(e − w p), as long as l.
    const Eigen::Vector3d eye = picture.view.eye - picture.view.w * origin_;
    const Rows towards =
        (float(-picture.view.w) * positions_).rowwise() + eye.cast<float>().transpose();
    const Column facing = towards.cwiseProduct(normals_).rowwise().sum().array() /
                          towards.rowwise().norm().array().max(1e-30f);
    const Column off_centre = (x.square() + y.square()) / depth.square() + 1;
    // What an equal part of the surface covers of the picture, mainly in the middle.
    const Column weight = (w_of_clip > least_depth).cast<float>() *
                          (facing.max(0.f) + turned_away * facing.abs()) /
                          (off_centre.square().square() * depth.square());
    const double sum = weight.sum();
    if (!(sum > 0)) return 0;
    const double mean_depth = std::exp((weight * depth.log()).sum() / sum);
    return 2 * mean_depth /
           (std::abs(picture.projection(1, 1)) * picture.height *
            meshlab_host::meanScale(picture.to_eye));
}

std::size_t SurfaceSamples::bytes() const {
    return std::size_t(positions_.size() + normals_.size()) * sizeof(float);
}
