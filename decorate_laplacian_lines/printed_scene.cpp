// SPDX-License-Identifier: GPL-3.0-or-later
#include "printed_scene.h"

#include <Eigen/LU>
#include <algorithm>

#include "meshlab_host/field_source.h"

using laplacian_lines::Progress;

namespace {

/// Of the paper, as the drawing filter has them.
line_drawing::SheetOptions sheet_options(const DecorationParameters& chosen) {
    line_drawing::SheetOptions options;
    options.style = line_drawing::style_on_paper(chosen.style);
    if (const auto azimuth = light_azimuth(chosen))
        options.light = meshlab_host::towards_light(*azimuth);
    if (chosen.appearance.hidden != line_renderer::HiddenLines::LeftOut)
        options.hidden = line_drawing::HiddenLines::Dashed;
    const double factor = chosen.outline_width / pen(line_drawing::LineClass::Outline);
    for (const auto outline : {line_drawing::LineClass::Outline, line_drawing::LineClass::Contour})
        options.pens[std::size_t(outline)] *= factor;
    return options;
}

}  // namespace

std::vector<ColoredInk> inks_of(const DecorationParameters& chosen) {
    std::vector<ColoredInk> inks;
    for (const auto& kind : laplacian_lines::kLineKinds) {
        if (!chosen.style.shows[kind.kind]) continue;
        const QColor& color = chosen.appearance.looks[std::size_t(kind.kind)].color;
        auto own = std::find_if(inks.begin(), inks.end(),
                                [&](const ColoredInk& ink) { return ink.color == color; });
        if (own == inks.end()) own = inks.insert(own, {{{}, false}, color});
        own->ink.kinds[kind.kind] = true;
    }
    // Outlines lie over others, hidden lines below.
    std::stable_partition(inks.begin(), inks.end(), [](const ColoredInk& ink) {
        return !ink.ink.kinds[laplacian_lines::LineKind::Contour];
    });
    if (chosen.appearance.hidden == line_renderer::HiddenLines::Faint) {
        QColor faint = chosen.line_color;
        faint.setAlphaF(line_renderer::kFaintAlpha);
        inks.insert(inks.begin(), {{laplacian_lines::all_kinds(), true}, faint});
    }
    return inks;
}

PrintedScene::PrintedScene(std::vector<LayerInScene> layers)
    : layers_(std::move(layers)), to_world_(layers_.at(0).to_world) {
    if (!meshlab_host::similarity_of(to_world_)) to_world_.setIdentity();
}

void PrintedScene::transform_layers(const Progress& progress) {
    std::list<TransformedLayer> placed;
    line_drawing::Objects objects;
    for (const LayerInScene& layer : layers_) {
        const PrintableMesh& own = *layer.mesh;
        if (layer.to_world == to_world_) {
            objects.push_back(
                {own.mesh, own.field ? &*own.field : nullptr, {}, own.extractor.get(), own.kernel});
            continue;
        }
        placed.push_back({own.mesh, own.field});
        meshlab_host::apply_transform(to_world_.inverse() * layer.to_world, own.options,
                                      placed.back().mesh, placed.back().field, progress);
        objects.push_back(
            {placed.back().mesh, placed.back().field ? &*placed.back().field : nullptr});
    }
    transformed_ = std::move(placed);
    objects_ = std::move(objects);
}

void PrintedScene::prepare(const Progress& progress) {
    if (objects_.empty()) transform_layers(progress);
    if (!painter_) painter_.emplace(objects_);
    painter_->prepare(progress);
}

Print PrintedScene::paint(const line_drawing::WindowView& window,
                          const DecorationParameters& chosen, bool may_wait,
                          const Progress& progress) {
    prepare(progress);
    for (TransformedLayer& layer : transformed_)
        if (layer.field && chosen.style.shows.needs_derivatives())
            meshlab_host::ensure_derivatives(layer.mesh, *layer.field, progress);
    std::vector<line_drawing::Ink> inks;
    for (const ColoredInk& ink : inks_of(chosen))
        inks.push_back(ink.ink);
    line_drawing::PaintedView painted =
        painter_->paint(window, sheet_options(chosen), inks, may_wait, progress);
    return {std::make_shared<line_renderer::InkPicture>(
                line_renderer::InkPicture{painted.size, std::move(painted.inks)}),
            painted.is_final};
}

std::optional<line_drawing::WindowView> window_of(const Eigen::Matrix4d& to_eye,
                                                  const Eigen::Matrix4d& projection,
                                                  const Eigen::Vector2i& size,
                                                  double pixels_per_mm) {
    const std::optional<meshlab_host::Similarity> similarity = meshlab_host::similarity_of(to_eye);
    if (!similarity) return std::nullopt;
    const Eigen::Matrix3d& axes = similarity->rotation;
    line_drawing::ViewFrame frame =
        line_drawing::frame_of_axes("View", axes.row(2).normalized(), axes.row(1).normalized());
    if (!meshlab_host::is_orthographic(projection)) frame.eye = to_eye.inverse().col(3).head<3>();
    return line_drawing::WindowView{frame, projection * to_eye, size, pixels_per_mm};
}
