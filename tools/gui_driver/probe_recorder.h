// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGLWidget>
#include <vector>

#include "line_probe.h"

class GLLogStream;

namespace driver {

/// Redraws the view and returns what probeLayer() says of each layer whose "Laplacian Lines Probe"
/// decoration is on. CommandError when no layer has it on.
std::vector<ProjectedLines> recordRedraw(QGLWidget* view, const ProbeOptions& options);

/// Redraws the view and returns the state of OpenGL as it is when the probe's decoration is drawn.
QString recordGlState(QGLWidget* view);

/// Redraws the view and returns the boxes of text that it shows in front of the layers, "TITLE:
/// TEXT" and a line end each.
QString recordBoxes(QGLWidget* view);

/// To be called by the probe's decoration; does nothing outside these functions.
void layerIsDrawn(const MeshModel& mesh, const GLLogStream& log);

}  // namespace driver
