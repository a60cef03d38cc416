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

/// Whether the depth buffer leaves a point of a line to be seen. Points within the plugin's depth
/// tolerance of a surface may be drawn or not.
enum class Sight { Visible, Unsure, Hidden };

struct ProjectedSample {
    Eigen::Vector2d pixel;  ///< from the upper left corner of the view
    Sight sight;
};

/// The lines of one layer on the screen, sampled at every half pixel.
struct ProjectedLines {
    std::vector<ProjectedSample> samples;
    int lines = 0;
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

/// To be called by the probe's decoration when it is drawn: hands the layer to the command that
/// looks at the redraw.
void layerIsDrawn(const MeshModel& mesh, const GLLogStream& log);

}  // namespace driver
