// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/object.h"
#include "meshlab_host/filter.h"

/// A layer as it stands in the world, copied: it may go while the progress bar runs the event loop.
struct PlacedLayer {
    QString name;
    laplacian_lines::TriangleMesh mesh;
    /// As the user has computed it; none: the drawing's scale decides about the kernel.
    std::optional<laplacian_lines::Field> field;
};
using PlacedLayers = std::vector<PlacedLayer>;

/// What is wanted of layers.
struct LayerChoice {
    bool all_visible;  ///< or the current one alone
    bool derivatives;  ///< of the curvature, in the fields
};

/// The layers that are drawn, in the order of the document, with their fields, by `share` of all
/// work. Of all visible ones, those that have no faces or cannot be drawn are left out, and the log
/// says why.
/// @throws laplacian_lines::Error if none is left, Cancelled.
PlacedLayers placeLayers(const LayerChoice& choice, const meshlab_host::FilterRun& run,
                         double share);

/// The same without their fields, and without those that cannot be drawn; perhaps none. Of large
/// meshes coarse copies: in some views, their bounds are slightly too small.
PlacedLayers placeShapes(const MeshDocument& document, bool all_visible);

/// What is different once a layer has moved or was edited, as good as always.
struct LayerState {
    int number, vertices, faces;
    std::array<double, 22> place;  ///< transformation and bounds

    bool operator==(const LayerState& other) const;
};
/// Of the layers that placeShapes() takes.
std::vector<LayerState> layerStates(const MeshDocument& document, bool all_visible);

/// Valid as long as the layers.
line_drawing::Objects objectsOf(const PlacedLayers& layers);
/// "a.ply, b.ply"
QString namesOf(const PlacedLayers& layers);
