// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_dialog.h"

#include "drawing_parameters.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/object.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/documents.h"

namespace {

QString objectInWords(const PlacedLayers& layers, const DrawingParameters& chosen) {
    const line_drawing::MeshUnit& unit = line_drawing::mesh_units[chosen.unit];
    Eigen::AlignedBox3d box;
    for (const PlacedLayer& layer : layers)
        box.extend(line_drawing::boundsOf(layer.mesh));
    if (box.isEmpty()) return "There is nothing to draw.";
    return QString("1 unit = 1 %1: %2 %3 in size.")
        .arg(unit.name, layers.size() > 1 ? "together the objects are" : "the object is",
             inQt(line_drawing::sizeInWords(unit.mm * box.sizes())));
}

QString planInWords(const line_drawing::SheetPlan& plan, const std::string& paper) {
    const QString size = paper == "fit"
                             ? QString("%1 x %2 mm").arg(plan.paper.x()).arg(plan.paper.y())
                             : inQt(paper).toUpper();
    if (plan.scale == 0) return QString("In perspective, without a scale, on %1.").arg(size);
    return QString("Fits %1 at %2.").arg(size, inQt(line_drawing::scaleInWords(plan.scale)));
}

/// Keeps triangles with all vertices of the mesh, once each: the same size, six times as fast.
void thin(laplacian_lines::TriangleMesh& mesh) {
    std::vector<bool> is_used(mesh.positions.size());
    for (const laplacian_lines::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            if (vertex < is_used.size()) is_used[vertex] = true;
    mesh.triangles.clear();
    laplacian_lines::Triangle next{};
    std::size_t corners = 0;
    for (std::uint32_t vertex = 0; vertex < is_used.size(); ++vertex) {
        if (!is_used[vertex]) continue;
        if (corners % 3 == 0) next.fill(vertex);
        next[corners % 3] = vertex;
        if (++corners % 3 == 0) mesh.triangles.push_back(next);
    }
    if (corners % 3 != 0) mesh.triangles.push_back(next);
}

}  // namespace

void DrawingOutlook::look(const MeshDocument& document, bool all_visible) {
    std::vector<LayerState> states = layerStates(document, all_visible);
    if (states == seen_) return;
    layers_ = placeShapes(document, all_visible);
    for (PlacedLayer& layer : layers_)
        thin(layer.mesh);
    seen_ = std::move(states);
}

std::optional<QString> DrawingOutlook::inWords(
    const MeshDocument& document,
    const std::function<std::optional<QString>(const QString& label)>& text_of) {
    if (meshlab_host::isBusy(document)) return std::nullopt;
    QString words;
    try {
        const DrawingParameters chosen = drawingParametersIn(text_of);
        look(document, chosen.is_of_all_layers);
        words = objectInWords(layers_, chosen);
        const line_drawing::SheetOptions options =
            sheetOptions(chosen, meshlab_host::currentView());
        words +=
            " " + planInWords(line_drawing::planSheet(objectsOf(layers_), options), options.paper);
    } catch (const std::exception& error) {
        words += " " + QString::fromLocal8Bit(error.what());
    }
    return words.trimmed();
}
