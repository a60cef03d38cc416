// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "action_table.h"

namespace driver {
namespace {

QStringList duplicate(Table& t) {
    if (!t.hasMesh() || t.now.layers.size() >= most_layers) return {};
    return t.filter("Duplicate Current layer");
}

QStringList chooseLayer(Table& t) {
    if (t.now.layers.empty()) return {};
    return {(t.dice.oneIn(2) ? "select-layer " : "show-layer ") + t.someLayer()};
}

QStringList deleteLayer(Table& t) {
    if (t.now.layers.empty()) return {};
    return {"delete-layer " + t.someLayer()};
}

// 2025.07 divides by the number of faces when it shows in a new view what had some until they were
// deleted.
bool mayBeShownAnew(const MeshModel* layer) {
    return layer->cm.fn > 0 || layer->cm.en > 0;
}

QStringList splitView(Table& t) {
    const auto& layers = t.now.layers;
    if (!t.hasMesh() || t.now.views >= most_views ||
        !std::all_of(layers.begin(), layers.end(), mayBeShownAnew))
        return {};
    return {t.dice.oneIn(2) ? "trigger Horizontally" : "trigger Vertically",
            "check Laplacian Lines on"};
}

// MeshLab keeps a pointer to the view from which the last filter's dialog was opened, and 2020.09
// uses it when the next one is opened: this has to be another view than the one that is closed.
QStringList closeView(Table& t) {
    if (t.now.views < 2 || t.faces() == 0) return {};
    const int closed = t.dice.below(t.now.views), other = (closed + 1) % t.now.views;
    return {QString("view %1").arg(other), "trigger Laplacian Smooth", "close",
            QString("view %1").arg(closed), "trigger Close current view"};
}

QStringList chooseView(Table& t) {
    if (t.now.views == 0) return {};
    return {QString("view %1").arg(t.dice.below(t.now.views))};
}

QStringList moveCamera(Table& t) {
    if (t.now.views == 0) return {};
    switch (t.dice.below(4)) {
        case 0: {
            const double distance = t.dice.oneIn(4) ? 0.5 : 4;  // perhaps inside
            return {QString("look %1 %2 %3 0 0 0")
                        .arg(t.number(-distance, distance), t.number(-distance, distance),
                             t.number(0.1, distance))};
        }
        case 1:
            return {"wheel " + t.number(-10, 10)};
        case 2:
            return {"slot view resetTrackBall"};
        default: {
            const QStringList buttons{"left", "middle"};
            return {QString("drag %1 %2 %3 %4 %5")
                        .arg(t.number(0.2, 0.8), t.number(0.2, 0.8), t.number(0.2, 0.8),
                             t.number(0.2, 0.8), t.dice.from(buttons))};
        }
    }
}

QStringList toggleOrthographic(Table& t) {
    return t.now.views ? QStringList{"trigger Toggle Orthographic Camera"} : QStringList();
}

QStringList renderMode(Table& t) {
    if (!t.hasMesh()) return {};
    const QStringList modes{"Points", "Wireframe", "Fill", "Fill", "Bounding Box"};
    return {"check " + t.dice.from(modes) + t.onOrOff()};
}

QStringList otherDecorations(Table& t) {
    if (!t.hasMesh()) return {};
    const QStringList names{"Show Normal", "Show Box Corners", "Show Trackball", "Show Info Panel"};
    return {"check " + t.dice.from(names) + t.onOrOff()};
}

QStringList takeSnapshot(Table& t) {
    if (t.now.views == 0) return {};
    return {QString("snapshot random.png %1").arg(1 + t.dice.below(2))};
}

QStringList newProject(Table& t) {
    if (t.now.documents >= most_documents) return {};
    return {"trigger New Empty Project...", "open " + t.dice.from(t.meshes),
            "check Laplacian Lines on"};
}

QStringList openProject(Table& t) {
    if (t.now.documents >= most_documents) return {};
    return {"slot window openProject scene.mlp", "check Laplacian Lines on"};
}

// 2020.09 and 2022.02 do not survive, whatever their plugins, that the only project is closed once
// more: an event comes for a window that is gone.
QStringList closeProject(Table& t) {
    return t.now.documents > 1 ? QStringList{"trigger Close Project"} : QStringList();
}

QStringList chooseDocument(Table& t) {
    return {QString("document %1").arg(t.dice.below(t.now.documents))};
}

}  // namespace

QStringList openMesh(Table& t) {
    if (t.now.layers.size() >= most_layers) return {};
    return {"open " + t.dice.from(t.meshes), "check Laplacian Lines on"};
}

QStringList leaveUselessLayer(Table& t) {
    QStringList lines = chooseLayer(t);
    return lines.isEmpty() || t.dice.oneIn(2) ? openMesh(t) : lines;
}

const std::vector<UserAction>& viewActions() {
    static const std::vector<UserAction> actions = {
        {5, openMesh},           {3, duplicate},   {6, chooseLayer},      {4, deleteLayer},
        {4, splitView},          {3, closeView},   {3, chooseView},       {12, moveCamera},
        {3, toggleOrthographic}, {6, renderMode},  {2, otherDecorations}, {2, takeSnapshot},
        {2, newProject},         {2, openProject}, {1, closeProject},     {2, chooseDocument},
    };
    return actions;
}

}  // namespace driver
