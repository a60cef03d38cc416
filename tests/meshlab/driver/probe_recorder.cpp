// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include "probe_recorder.h"

#include "command_table.h"

namespace driver {
namespace {

// Set while recordRedraw() waits for the redraw; everything happens on the GUI's thread.
const ProbeOptions* recording = nullptr;
std::vector<ProjectedLines> recorded;
QString problem;

}  // namespace

std::vector<ProjectedLines> recordRedraw(QGLWidget* view, const ProbeOptions& options) {
    recorded.clear();
    problem.clear();
    recording = &options;
    view->repaint();
    recording = nullptr;
    if (!problem.isEmpty()) throw CommandError(problem);
    if (recorded.empty())
        throw CommandError("no layer has the decoration Laplacian Lines Probe switched on");
    return std::move(recorded);
}

void layerIsDrawn(const MeshModel& mesh) {
    if (!recording) return;
    try {
        recorded.push_back(probeLayer(mesh, *recording));
    } catch (const std::exception& e) {  // none may pass through MeshLab's drawing
        problem = e.what();
    }
}

}  // namespace driver
