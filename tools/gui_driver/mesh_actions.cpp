// SPDX-License-Identifier: GPL-3.0-or-later
#include "action_table.h"
#include "random_values.h"

namespace driver {
namespace {

QStringList changeDecoration(Table& t) {
    if (!t.now.has_lines) return {};
    const DecorationSetting setting = randomDecorationSetting(t.dice);
    t.to_mend << "setdeco " + setting.usual;
    return {"setdeco " + setting.random};
}

QStringList compute(Table& t) {
    if (!t.hasMesh()) return {};
    return t.filter("Compute Laplacian Lines", randomComputeSettings(t.dice));
}

QStringList polylines(Table& t) {
    if (!t.hasMesh() || t.now.layers.size() >= most_layers) return {};
    return t.filter("Generate Laplacian Lines Polylines", randomPolylineSettings(t.dice));
}

/// Where faces know their neighbours, or vertices their faces, MeshLab's own assertions may end it
/// when some are deleted.
bool mayLoseFaces(Table& t) {
    return t.faces() > 0 && !t.now.current->cm.face.IsFFAdjacencyEnabled() &&
           !t.now.current->cm.vert.IsVFAdjacencyEnabled();
}

// In several views 2022.02 and 2025.07 may divide by the number of faces that are left, in the code
// that fills the buffers of OpenGL.
QStringList deleteFaces(Table& t) {
    if (!mayLoseFaces(t)) return {};
    QStringList lines =
        t.filter("Conditional Face Selection", {"boolean function = x0 > " + t.number(-1.5, 1.5)});
    if (t.dice.oneIn(8) && t.now.views == 1) return t.filter("Delete ALL Faces");
    return lines << "trigger Delete Selected Faces";
}

QStringList deform(Table& t) {
    if (!t.hasMesh()) return {};
    const QStringList functions{"z + 0.1 * sin(5 * x)",
                                "z * 1000",
                                "z + 1000000",
                                "z * 1.1",
                                "z + 1",
                                "z / 0",
                                "z * 0.999"};
    return t.filter("Per Vertex Geometric Function", {"func z = = " + t.dice.from(functions)});
}

// MeshLab shows the result at once, and takes it back unless it is applied.
QStringList preview(Table& t) {
    if (t.faces() == 0) return {};
    QStringList lines{"trigger Laplacian Smooth", "set Smoothing steps = 2", "set Preview = on"};
    if (t.dice.oneIn(3)) lines << changeDecoration(t);
    if (t.dice.oneIn(2)) lines << "set Smoothing steps = 5";
    if (t.dice.oneIn(2)) lines << "set Preview = off";
    if (t.dice.oneIn(2)) lines << "apply";
    return lines << "close";  // 2020.09 does not survive that a mesh is opened meanwhile
}

QStringList smooth(Table& t) {
    if (t.faces() == 0) return {};
    return t.filter("Laplacian Smooth",
                    {"Smoothing steps = " + QString::number(1 + t.dice.below(3))});
}

QStringList subdivide(Table& t) {
    if (t.faces() == 0 || t.faces() > most_faces / 4) return {};
    return {"trigger Subdivision Surfaces: Loop", "set Iterations = 1",
            "set Edge Threshold (abs and %) = 1%", "apply", "close"};
}

/// They also end it when it simplifies meshes with degenerate faces.
bool isSound(const CMeshO& mesh) {
    constexpr double least_area = 1e-8, largest = 1e4;
    for (const CFaceO& face : mesh.face) {
        if (face.IsD()) continue;
        if (!(vcg::DoubleArea(face) > least_area)) return false;
        for (int corner = 0; corner < 3; ++corner)
            if (!(double(face.cP(corner).Norm()) < largest)) return false;
    }
    return true;
}

QStringList simplify(Table& t) {
    if (!mayLoseFaces(t) || !isSound(t.now.current->cm)) return {};
    return t.filter("Simplification: Quadric Edge Collapse Decimation",
                    {QString("Target number of faces = %1").arg(t.dice.below(t.faces() + 1))});
}

QStringList turnInsideOut(Table& t) {
    if (t.faces() == 0) return {};
    return t.filter("Invert Faces Orientation", {"Force Flip = on"});
}

QStringList transform(Table& t) {
    if (!t.hasMesh()) return {};
    const QStringList scales{"1", "0.5", "-1", "2", "0", "1000"};
    return t.filter("Matrix: Set from translation/rotation/scale",
                    {"Freeze Matrix =" + t.onOrOff(), "X Translation = " + t.number(-2, 2),
                     "Y Rotation = " + t.number(-180, 180), "X Scale = " + t.dice.from(scales)});
}

QStringList freeze(Table& t) {
    return t.hasMesh() ? t.filter("Matrix: Freeze Current Matrix") : QStringList();
}

// As edit tools do, without a word to decorations.
QStringList edit(Table& t) {
    return t.hasMesh() ? QStringList{"stretch " + t.number(0.8, 1.2)} : QStringList();
}

// From 2022.02 on, a hidden layer is then called visible and yet not drawn.
QStringList reload(Table& t) {
    return t.hasMesh() && t.now.current->isVisible() ? QStringList{"trigger Reload"}
                                                     : QStringList();
}

}  // namespace

QStringList toggleLines(Table& t) {
    if (!t.hasMesh()) return {};
    const bool off = t.now.has_lines || t.dice.oneIn(8);
    return {off ? "check Laplacian Lines off" : "check Laplacian Lines on"};
}

// Else nothing would be drawn for long: one bad value is enough.
QStringList mendDecoration(Table& t) {
    if (!t.now.has_lines) return {};
    QStringList lines;
    lines.swap(t.to_mend);
    return lines;
}

const std::vector<UserAction>& meshActions() {
    static const std::vector<UserAction> actions = {
        {6, toggleLines},   {12, changeDecoration}, {10, compute}, {5, polylines}, {4, deleteFaces},
        {4, deform},        {3, preview},           {4, smooth},   {3, subdivide}, {3, simplify},
        {2, turnInsideOut}, {5, transform},         {3, freeze},   {4, reload},    {3, edit},
    };
    return actions;
}

}  // namespace driver
