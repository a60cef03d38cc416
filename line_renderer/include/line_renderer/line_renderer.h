// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QObject>
#include <map>
#include <string>

#include "laplacian_lines/line_set.h"
#include "line_renderer/line_program.h"
#include "line_renderer/line_stream.h"
#include "line_renderer/redraw_clock.h"
#include "line_renderer/share_group.h"
#include "line_renderer/surface_depth.h"

namespace line_renderer {

/// What is drawn of the parts of lines that the surface hides.
enum class HiddenLines { LeftOut, Faint, Dashed };

/// How lines look.
struct LineAppearance {
    QColor color = Qt::black;          ///< of Laplacian lines
    QColor contour_color = Qt::black;  ///< of occluding contours
    HiddenLines hidden = HiddenLines::LeftOut;
    double width = 1.6;           ///< pixels, of a Laplacian line of full weight
    double contour_factor = 1.3;  ///< width of contours in Laplacian line widths
};

/// Where lines are drawn.
struct LinePlacement {
    Eigen::Matrix4d to_eye;      ///< mesh coordinates to eye coordinates
    Eigen::Matrix4d projection;  ///< eye coordinates to clip coordinates
    double diagonal = 1;         ///< of the mesh, mesh units
    double mean_edge = 0;        ///< of the mesh, mesh units
    double pixel_scale = 1;      ///< pixels of the viewport for one of the appearance
    double mark_pixels = 0;      ///< diameter of MeshLab's points or wires on the surface
    DepthTexture depths{};       ///< of what hides lines
};

/// Draws line sets with OpenGL over what is in the depth buffer. Holds a program and buffers for
/// each share group, which live as long as the group: no view that closes takes them
/// from another. GUI thread only.
class LineRenderer {
public:
    /// Hands lines over to OpenGL, for drawing with the same appearance and placement. Returns why
    /// nothing can be drawn, empty on success. No allocation while sets get no larger.
    std::string upload(const laplacian_lines::LineSet& lines, const LineAppearance& appearance,
                       const LinePlacement& placement);
    /// Draws what was uploaded last into the current context's viewport. Both leave the OpenGL
    /// state as it was. `clock` counts the draw calls themselves as drawing.
    void draw(const LineAppearance& appearance, const LinePlacement& placement, RedrawClock& clock);

private:
    struct GroupObjects {
        LineProgram program;
        GLuint corners = 0;        ///< buffer with the corners of a quad
        GLuint stream = 0;         ///< buffer for this frame's points
        std::size_t capacity = 0;  ///< points that it has room for
    };

    struct Pass;

    GroupObjects& objectsOfCurrentGroup();
    /// Memory for stream_length_ points in the buffer, which is bound; null if there is none.
    StreamPoint* mapStream(GroupObjects& objects);
    void bindStream(const GroupObjects& objects);
    void drawHidden(const LineProgram& program, const LineAppearance& appearance,
                    const LinePlacement& placement, RedrawClock& clock);
    void drawPass(const LineProgram& program, const LinePlacement& placement, const Pass& pass,
                  RedrawClock& clock);

    std::map<ShareGroup, GroupObjects> groups_;
    std::size_t stream_length_ = 0;  ///< points of what was uploaded last
    QObject receiver_;               ///< of the groups' last words; destroyed first
};

}  // namespace line_renderer
