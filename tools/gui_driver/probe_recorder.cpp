// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include "probe_recorder.h"

#include <functional>

#include "command_table.h"
#include "gl_state_text.h"
#include "meshlab_host/meshlab_api.h"

namespace driver {
namespace {

// Set while a redraw is recorded; everything happens on the GUI's thread.
using Recorder = std::function<void(const MeshModel&, const GLLogStream&)>;
Recorder record;
int recorded_layers = 0;
QString problem;

void redraw(QGLWidget* view, Recorder recorder) {
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
    redraw(view, [&](const MeshModel& mesh, const GLLogStream&) {
        layers.push_back(probeLayer(mesh, options));
    });
    return layers;
}

QString recordGlState(QGLWidget* view) {
    QString text;
    redraw(view, [&](const MeshModel&, const GLLogStream&) { text += glStateText(); });
    return text;
}

QString recordBoxes(QGLWidget* view) {
    QString text;
    redraw(view, [&](const MeshModel&, const GLLogStream& log) {
        text.clear();  // each layer sees the boxes of those before it
        const auto& boxes = log.realTimeLogMultiMap();
        for (auto box = boxes.begin(); box != boxes.end(); ++box)
            text += box.key() + ": " + box.value().second + "\n";
    });
    return text;
}

void layerIsDrawn(const MeshModel& mesh, const GLLogStream& log) {
    if (!record) return;
    ++recorded_layers;
    try {
        record(mesh, log);
    } catch (const std::exception& e) {  // none may pass through MeshLab's drawing
        problem = e.what();
    }
}

}  // namespace driver
