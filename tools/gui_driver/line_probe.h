// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <laplacian_lines/line_style.h>
#include <laplacian_lines/precompute_options.h>

#include <QImage>
#include <QString>
#include <vector>

#include "projected_lines.h"

class MeshModel;

// Compares what MeshLab shows with the lines that the core extracts for the camera, by a way of its
// own from the GL matrices to the picture: nothing of the decoration plugin is used.
namespace driver {

struct ProbeOptions {
    laplacian_lines::PrecomputeOptions field;
    laplacian_lines::LineStyle style;
    /// Towards a distant light, x to the right of the picture, y up, z to the viewer; zero: the
    /// light is at the eye.
    Eigen::Vector3d light = Eigen::Vector3d::Zero();
};

/// What is drawn in one layer at one redraw: called by the probe's decoration while MeshLab's
/// matrices and depth buffer are those of the layer.
ProjectedLines probeLayer(const MeshModel& mesh, const ProbeOptions& options);

struct ProbeResult {
    int expected = 0;     ///< samples of lines that must be seen
    int found = 0;        ///< those with ink beside them
    int inked = 0;        ///< pixels with ink
    int unexplained = 0;  ///< those with no line beside them
};

/// Ink is what has this colour more than the background; `reach` in pixels.
ProbeResult compareWithPicture(const std::vector<ProjectedLines>& layers, const QImage& picture,
                               const QColor& ink, double reach);

}  // namespace driver
