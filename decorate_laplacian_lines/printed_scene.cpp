// SPDX-License-Identifier: GPL-3.0-or-later
#include "printed_scene.h"

#include <Eigen/LU>

#include "meshlab_host/camera.h"
#include "meshlab_host/field_source.h"

using laplacian_lines::Progress;

PrintedScene::PrintedScene(laplacian_lines::TriangleMesh mesh,
                           std::optional<laplacian_lines::Field> field)
    : mesh_(std::move(mesh)), field_(std::move(field)) {}

void PrintedScene::demandDerivatives(const Progress& progress) {
    if (!field_ || field_->has_derivatives()) return;
    painter_.reset();
    meshlab_host::demandDerivatives(mesh_, *field_, progress);
}

line_renderer::InkPicturePointer PrintedScene::paint(const line_drawing::WindowView& window,
                                                     const line_drawing::SheetOptions& options,
                                                     const Progress& progress) {
    if (options.style.shows.needs_derivatives()) demandDerivatives(progress);
    if (!painter_)
        painter_.emplace(line_drawing::Objects{{mesh_, field_ ? &*field_ : nullptr, {}}});
    line_drawing::GrayPicture picture = painter_->paint(window, options, progress);
    return std::make_shared<line_renderer::InkPicture>(
        line_renderer::InkPicture{picture.size, std::move(picture.grays)});
}

std::optional<line_drawing::WindowView> windowOf(const Eigen::Matrix4d& to_eye,
                                                 const Eigen::Matrix4d& projection,
                                                 const Eigen::Vector2i& size,
                                                 double pixels_per_mm) {
    const std::optional<meshlab_host::Similarity> similarity = meshlab_host::similarityOf(to_eye);
    if (!similarity) return std::nullopt;
    const Eigen::Matrix3d& axes = similarity->rotation;
    line_drawing::ViewFrame frame{line_drawing::Side::Other, "View", axes.row(0).normalized(),
                                  axes.row(1).normalized(), axes.row(2).normalized()};
    if (!meshlab_host::isOrthographic(projection)) frame.eye = to_eye.inverse().col(3).head<3>();
    return line_drawing::WindowView{frame, projection * to_eye, size, pixels_per_mm};
}
