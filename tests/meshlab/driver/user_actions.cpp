// SPDX-License-Identifier: GPL-3.0-or-later
#include "user_actions.h"

#include "random_values.h"

namespace driver {
namespace {

// More would show nothing else, only slower.
constexpr int kMostLayers = 4, kMostViews = 3, kMostDocuments = 3, kMostFaces = 12000;

struct Table {
    Dice& dice;
    const Situation& now;
    const QStringList& meshes;
    QStringList& to_mend;  // settings that were changed, as they were

    QString onOrOff() { return dice.oneIn(2) ? " on" : " off"; }
    QString number(double from, double to) { return QString::number(dice.between(from, to)); }
    bool hasMesh() const { return now.current; }
    int faces() const { return now.current ? now.current->cm.fn : 0; }
    QString someLayer() { return QString::number(dice.from(now.layers)->id()); }

    QStringList filter(const QString& name, const QStringList& settings = {}) {
        QStringList lines{"trigger " + name};
        for (const QString& setting : settings)
            lines << "set " + setting;
        lines << "apply";
        if (dice.oneIn(4)) lines << "apply";
        if (!dice.oneIn(6)) lines << "close";  // dialogs may stay open
        return lines;
    }
};

// Weight, then what to do; nothing if it is impossible now.
struct UserAction {
    int weight;
    QStringList (*lines)(Table&);
};

QStringList toggleLines(Table& t) {
    if (!t.hasMesh()) return {};
    return {t.dice.oneIn(4) ? "check Laplacian Lines off" : "check Laplacian Lines on"};
}

QStringList changeDecoration(Table& t) {
    if (!t.now.has_lines) return {};
    const DecorationSetting setting = randomDecorationSetting(t.dice);
    t.to_mend << "setdeco " + setting.usual;
    return {"setdeco " + setting.random};
}

// Else nothing would be drawn for long: one bad value is enough.
QStringList mendDecoration(Table& t) {
    if (!t.now.has_lines) return {};
    QStringList lines;
    lines.swap(t.to_mend);
    return lines;
}

QStringList compute(Table& t) {
    if (!t.hasMesh()) return {};
    return t.filter("Compute Laplacian Lines", randomComputeSettings(t.dice));
}

QStringList polylines(Table& t) {
    if (!t.hasMesh() || t.now.layers.size() >= kMostLayers) return {};
    return t.filter("Generate Laplacian Lines Polylines", randomPolylineSettings(t.dice));
}

QStringList deleteFaces(Table& t) {
    if (t.faces() == 0) return {};
    QStringList lines =
        t.filter("Conditional Face Selection", {"boolean function = x0 > " + t.number(-1.5, 1.5)});
    lines << (t.dice.oneIn(8) ? "trigger Delete ALL Faces" : "trigger Delete Selected Faces");
    return lines;
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

QStringList smooth(Table& t) {
    if (t.faces() == 0) return {};
    return t.filter("Laplacian Smooth",
                    {"Smoothing steps = " + QString::number(1 + t.dice.below(3))});
}

QStringList subdivide(Table& t) {
    if (t.faces() == 0 || t.faces() > kMostFaces / 4) return {};
    return {"trigger Subdivision Surfaces: Loop", "set Iterations = 1",
            "set Edge Threshold (abs and %) = 1%", "apply", "close"};
}

QStringList simplify(Table& t) {
    if (t.faces() == 0) return {};
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

QStringList openMesh(Table& t) {
    if (t.now.layers.size() >= kMostLayers) return {};
    return {"open " + t.dice.from(t.meshes), "check Laplacian Lines on"};
}

QStringList duplicate(Table& t) {
    if (!t.hasMesh() || t.now.layers.size() >= kMostLayers) return {};
    return t.filter("Duplicate Current layer");
}

QStringList reload(Table& t) {
    return t.hasMesh() ? QStringList{"trigger Reload"} : QStringList();
}

QStringList chooseLayer(Table& t) {
    if (t.now.layers.empty()) return {};
    return {(t.dice.oneIn(2) ? "select-layer " : "show-layer ") + t.someLayer()};
}

QStringList deleteLayer(Table& t) {
    if (t.now.layers.empty()) return {};
    return {"delete-layer " + t.someLayer()};
}

QStringList splitView(Table& t) {
    if (!t.hasMesh() || t.now.views >= kMostViews) return {};
    return {t.dice.oneIn(2) ? "trigger Horizontally" : "trigger Vertically",
            "check Laplacian Lines on"};
}

QStringList closeView(Table& t) {
    return t.now.views > 1 ? QStringList{"trigger Close current view"} : QStringList();
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
    if (t.now.documents >= kMostDocuments) return {};
    return {"trigger New Empty Project...", "open " + t.dice.from(t.meshes),
            "check Laplacian Lines on"};
}

QStringList closeProject(Table& t) {
    return t.now.documents > 0 ? QStringList{"trigger Close Project"} : QStringList();
}

QStringList chooseDocument(Table& t) {
    return {QString("document %1").arg(t.dice.below(t.now.documents))};
}

constexpr UserAction kActions[] = {
    {8, toggleLines},
    {12, changeDecoration},
    {4, mendDecoration},
    {10, compute},
    {5, polylines},
    {4, deleteFaces},
    {4, deform},
    {4, smooth},
    {3, subdivide},
    {3, simplify},
    {2, turnInsideOut},
    {5, transform},
    {3, freeze},
    {5, openMesh},
    {3, duplicate},
    {4, reload},
    {6, chooseLayer},
    {4, deleteLayer},
    {4, splitView},
    {3, closeView},
    {3, chooseView},
    {12, moveCamera},
    {3, toggleOrthographic},
    {6, renderMode},
    {2, otherDecorations},
    {2, takeSnapshot},
    {2, newProject},
    {2, chooseDocument},
    {1, closeProject},
};

const UserAction& byWeight(Dice& dice) {
    int total = 0;
    for (const UserAction& action : kActions)
        total += action.weight;
    int left = dice.below(total);
    for (const UserAction& action : kActions)
        if ((left -= action.weight) < 0) return action;
    return kActions[0];
}

}  // namespace

QStringList UserActions::next(const Situation& situation) {
    Table table{dice_, situation, meshes_, to_mend_};
    if (situation.documents == 0) return newProject(table);
    // little can be done without a mesh or without lines
    QStringList lines;
    if (!situation.current && dice_.oneIn(2)) return openMesh(table);
    if (!situation.has_lines && dice_.oneIn(4)) lines = toggleLines(table);
    while (lines.isEmpty())
        lines = byWeight(dice_).lines(table);
    return lines;
}

}  // namespace driver
