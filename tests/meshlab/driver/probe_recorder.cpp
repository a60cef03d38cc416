// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include "probe_recorder.h"

#include <functional>

#include "command_table.h"
#include "gl_state_text.h"

namespace driver {
namespace {

// Set while a redraw is recorded; everything happens on the GUI's thread.
std::function<void(const MeshModel&)> record;
int recorded_layers = 0;
QString problem;

void redraw(QGLWidget* view, std::function<void(const MeshModel&)> recorder) {
    recorded_layers = 0;
    problem.clear();
    record = std::move(recorder);
    view->repaint();
    record = nullptr;
    if (!problem.isEmpty()) throw CommandError(problem);
    if (recorded_layers == 0)
        throw CommandError("no layer has the decoration Laplacian Lines Probe switched on");
}

}  // namespace

std::vector<ProjectedLines> recordRedraw(QGLWidget* view, const ProbeOptions& options) {
    std::vector<ProjectedLines> layers;
    redraw(view, [&](const MeshModel& mesh) { layers.push_back(probeLayer(mesh, options)); });
    return layers;
}

QString recordGlState(QGLWidget* view) {
    QString text;
    redraw(view, [&](const MeshModel&) { text += glStateText(); });
    return text;
}

void layerIsDrawn(const MeshModel& mesh) {
    if (!record) return;
    ++recorded_layers;
    try {
        record(mesh);
    } catch (const std::exception& e) {  // none may pass through MeshLab's drawing
        problem = e.what();
    }
}

}  // namespace driver
