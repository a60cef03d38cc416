// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "laplacian_lines/field.h"
#include "line_drawing/view_painter.h"
#include "line_renderer/picture_renderer.h"

/// A mesh as the drawing filter would print it, with the field that the user has computed, if any.
/// Grows with the first picture. One thread at a time.
class PrintedScene {
public:
    PrintedScene(laplacian_lines::TriangleMesh mesh, std::optional<laplacian_lines::Field> field);

    /// @throws as line_drawing::ViewPainter::paint()
    line_renderer::InkPicturePointer paint(const line_drawing::WindowView& window,
                                           const line_drawing::SheetOptions& options,
                                           const laplacian_lines::Progress& progress);

private:
    void demandDerivatives(const laplacian_lines::Progress& progress);

    const laplacian_lines::TriangleMesh mesh_;
    std::optional<laplacian_lines::Field> field_;
    std::optional<line_drawing::ViewPainter> painter_;
};

/// The window of a layer, or none if lengths in it depend on the direction or left and right are
/// exchanged. `pixels_per_mm` of paper.
std::optional<line_drawing::WindowView> windowOf(const Eigen::Matrix4d& to_eye,
                                                 const Eigen::Matrix4d& projection,
                                                 const Eigen::Vector2i& size, double pixels_per_mm);
