// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <laplacian_lines/line_style.h>
#include <laplacian_lines/precompute_options.h>

#include <Eigen/Core>
#include <QImage>
#include <QString>
#include <vector>

class GLLogStream;
class MeshModel;

// Compares MeshLab's picture with the core's lines by an independent path from GL matrices to
// pixels: no code of the decoration.
namespace driver {

struct ProbeOptions {
    laplacian_lines::PrecomputeOptions field;
    laplacian_lines::LineStyle style;
    /// Towards a distant light: x right, y up, z to the viewer; zero: at the eye.
    Eigen::Vector3d light = Eigen::Vector3d::Zero();
};

/// By the depth buffer. Unsure: within the plugin's depth tolerance.
enum class Sight { Visible, Unsure, Hidden };

struct ProjectedSample {
    Eigen::Vector2d pixel;  ///< from the upper left corner of the view
    Sight sight;
};

/// Sampled at every half pixel.
struct ProjectedLines {
    std::vector<ProjectedSample> samples;
    int lines = 0;
};

/// One layer in one redraw: call it while MeshLab's matrices and depth buffer are the layer's.
ProjectedLines probeLayer(const MeshModel& mesh, const ProbeOptions& options);

struct ProbeResult {
    int expected = 0;     ///< samples of lines that must be seen
    int found = 0;        ///< those with ink beside them
    int inked = 0;        ///< pixels with ink
    int unexplained = 0;  ///< those with no line beside them
};

/// Ink has this colour rather than the background's; `reach` in pixels.
ProbeResult compareWithPicture(const std::vector<ProjectedLines>& layers, const QImage& picture,
                               const QColor& ink, double reach);

/// The probe's decoration calls this when drawn; hands the layer to the waiting command.
void layerIsDrawn(const MeshModel& mesh, const GLLogStream& log);

}  // namespace driver
