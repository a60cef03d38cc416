// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include <QTextStream>
#include <algorithm>

#include "command_table.h"
#include "core_lines.h"
#include "gui.h"
#include "mesh_noise.h"
#include "process.h"
#include "situation.h"
#include "view_properties.h"

namespace driver {
namespace {

const QString decoration = "Laplacian Lines";

/// MeshLab's message boxes are an error only if there is no mesh afterwards. The caller reports the
/// file.
Outcome load(const Command& command) {
    const std::size_t layers = presentSituation().layers.size();
    BoxAnswerer boxes;
    bool opened = false;
    QMetaObject::invokeMethod(requireMainWindow(), "importMeshWithLayerManagement",
                              Qt::DirectConnection, Q_RETURN_ARG(bool, opened),
                              Q_ARG(QString, command.rest));
    const QString said = boxes.takeTexts().join("; ");
    if (!opened || presentSituation().layers.size() <= layers)
        throw CommandError("MeshLab cannot read it" + (said.isEmpty() ? "" : ": " + said));
    if (!said.isEmpty()) say("remark: " + said.toStdString());
    return Outcome::Done;
}

/// Fails on an incomplete project, with MeshLab's message.
void openProject(const Command& command) {
    BoxAnswerer boxes;
    bool opened = false;
    QMetaObject::invokeMethod(requireMainWindow(), "openProject", Qt::DirectConnection,
                              Q_RETURN_ARG(bool, opened), Q_ARG(QString, command.rest));
    const QString said = boxes.takeTexts().join("; ");
    if (opened && said.isEmpty() && !presentSituation().layers.empty()) return;
    throw CommandError("MeshLab cannot open the project" + (said.isEmpty() ? "" : ": " + said));
}

/// From the log; empty if it gives no reason.
QString refusal() {
    const MeshModel* layer = presentSituation().current;
    const QString beginning = decoration + ": " + (layer ? layer->label() + ": " : QString());
    const QString log = logText();
    const int place = log.lastIndexOf(beginning);
    return place < 0 ? QString() : log.mid(place + beginning.size()).section('\n', 0, 0);
}

/// What the log has to say of meshes, once.
void sayWarnings() {
    static int told = 0;  // characters of the log
    const QString log = logText();
    for (const QString& line : log.mid(log.size() < told ? 0 : told).split('\n'))
        if (line.contains(": Warning: ")) say("warning: " + line.trimmed().toStdString());
    told = log.size();
}

void drawLines(const Command&) {
    QAction* action = requireAction(decoration);
    if (!action->isChecked()) action->trigger();
    sayWarnings();
    if (action->isChecked()) return;
    const QString reason = refusal();
    throw CommandError(reason.isEmpty() ? "MeshLab does not draw the lines" : reason);
}

/// MeshLab switches decorations on layer by layer; the log tells which have no lines.
void drawAllLines(const Command&) {
    for (const MeshModel* layer : presentSituation().layers) {
        makeLayerCurrent(layer);
        QAction* action = requireAction(decoration);
        if (!action->isChecked()) action->trigger();
    }
}

/// Lines thinner than a pixel would have gaps: small views use a window's widths.
void scaleLines(const Command& command) {
    QGLWidget* area = requireView();
    const double scale = std::min(area->width(), area->height()) / command.number(0);
    area->setProperty(line_scale_property, std::max(scale, 1.0));
    area->update();
}

using laplacian_lines::TriangleMesh;

void writePly(const TriangleMesh& mesh, const QString& name) {
    QByteArray content;
    QTextStream text(&content);
    text.setRealNumberPrecision(9);
    text << "ply\nformat ascii 1.0\nelement vertex " << mesh.positions.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
         << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Eigen::Vector3d& p : mesh.positions)
        text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& triangle : mesh.triangles)
        text << "3 " << triangle[0] << ' ' << triangle[1] << ' ' << triangle[2] << '\n';
    text.flush();
    writeFile(name, content);
}

// SHARE SEED FILE: moves each vertex by SHARE of the mean edge in a random direction.
void writeNoisy(const Command& command) {
    const MeshModel* layer = presentSituation().current;
    if (!layer) throw CommandError("there is no layer");
    writePly(mesh_noise::with_noise(liveTriangles(layer->cm), command.number(0),
                                    unsigned(command.number(1))),
             command.word(2));
}

/// So that pictures do not depend on timing.
void waitForLevels(const Command&) {
    requireView()->setProperty(waits_property, true);
}

}  // namespace

void addDrawingCommands(CommandTable& table) {
    table.add("load", load, Place::Everywhere);
    table.addSimple("open-project", openProject, Place::Everywhere);
    table.addSimple("draw-lines", drawLines);
    table.addSimple("draw-all-lines", drawAllLines);
    table.addSimple("scale-lines", scaleLines);
    table.addSimple("wait-for-levels", waitForLevels);
    table.addSimple("write-noisy", writeNoisy);
}

}  // namespace driver
