// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/object.h"
#include "meshlab_host/filter.h"

/// A copy in world coordinates: the layer may go while the progress bar runs the event loop.
struct WorldLayer {
    QString name;
    laplacian_lines::TriangleMesh mesh;
    /// As the user computed it; none: the kernel follows from the drawing's scale.
    std::optional<laplacian_lines::Field> field;
};
using WorldLayers = std::vector<WorldLayer>;

struct LayerChoice {
    bool all_visible;  ///< or the current one alone
    bool derivatives;  ///< of the curvature, in the fields
};

/// The layers to draw, in the document's order, with their fields, by `share` of all work. Skips
/// visible layers that have no faces or cannot be drawn; the log says why.
/// @throws laplacian_lines::Error if none is left, Cancelled
WorldLayers copy_layers(const LayerChoice& choice, const meshlab_host::FilterRun& run,
                        double share);

/// They refer to the layers, which outlive them.
line_drawing::Objects objects_of(const WorldLayers& layers);
/// "a.ply, b.ply"
QString names_of(const WorldLayers& layers);
