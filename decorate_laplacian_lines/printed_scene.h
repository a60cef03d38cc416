// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <optional>

#include "decoration_parameters.h"
#include "laplacian_lines/line_extractor.h"
#include "line_drawing/view_painter.h"
#include "line_renderer/picture_renderer.h"
#include "meshlab_host/mesh_transform.h"

/// A layer, for printed scenes.
struct PrintableMesh {
    laplacian_lines::TriangleMesh mesh;
    std::optional<laplacian_lines::Field> field;  ///< that the user has computed
    laplacian_lines::PrecomputeOptions options;   ///< of it
    std::shared_ptr<const laplacian_lines::LineExtractor> extractor;  ///< as live lines have it
    double kernel = 0;                                                ///< its √h, mesh units
};

struct LayerInScene {
    std::shared_ptr<PrintableMesh> mesh;
    Eigen::Matrix4d to_world;

    bool operator==(const LayerInScene& other) const {
        return mesh == other.mesh && to_world == other.to_world;
    }
};

/// Kinds of lines in one color, or what is behind the surface.
struct ColoredInk {
    line_drawing::Ink ink;
    QColor color;
};
std::vector<ColoredInk> inks_of(const DecorationParameters& chosen);

struct Print {
    line_renderer::InkPicturePointer picture;  ///< in the inks of inks_of(); null: none
    bool is_final = false;                     ///< false: another follows, with the right kernel
    double milliseconds = 0;                   ///< time it took
    QString missing_reason = {};               ///< why there is none, told once
};

/// Layers as the drawing filter would print them together. Grows with the first picture. One thread
/// at a time.
class PrintedScene {
public:
    static constexpr std::size_t most_triangles = 10000000;

    explicit PrintedScene(std::vector<LayerInScene> layers);

    bool is_of(const std::vector<LayerInScene>& layers) const { return layers_ == layers; }
    /// From its own coordinates, in which a window looks at it.
    const Eigen::Matrix4d& to_world() const { return to_world_; }

    /// What every view needs, unless that is done. @throws as paint()
    void prepare(const laplacian_lines::Progress& progress);
    /// @throws as line_drawing::ViewPainter::paint()
    Print paint(const line_drawing::WindowView& window, const DecorationParameters& chosen,
                bool may_wait, const laplacian_lines::Progress& progress);

private:
    struct TransformedLayer {
        laplacian_lines::TriangleMesh mesh;
        std::optional<laplacian_lines::Field> field;
    };

    void transform_layers(const laplacian_lines::Progress& progress);

    const std::vector<LayerInScene> layers_;
    Eigen::Matrix4d to_world_;
    std::list<TransformedLayer> transformed_;  ///< copies of layers with other transformations
    line_drawing::Objects objects_;
    std::optional<line_drawing::ViewPainter> painter_;
};

/// How a window of `size` pixels sees a scene from whose coordinates `to_eye` is; none if that is
/// no Similarity. `pixels_per_mm` of paper.
std::optional<line_drawing::WindowView> window_of(const Eigen::Matrix4d& to_eye,
                                                  const Eigen::Matrix4d& projection,
                                                  const Eigen::Vector2i& size,
                                                  double pixels_per_mm);
