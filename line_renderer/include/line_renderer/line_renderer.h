// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "laplacian_lines/line_set.h"
#include "line_renderer/depth_texture.h"
#include "line_renderer/line_appearance.h"
#include "line_renderer/redraw_clock.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;
struct StreamPart;

/// Where lines are drawn.
struct LinePlacement {
    Eigen::Matrix4d to_eye;      ///< mesh coordinates to eye coordinates
    Eigen::Matrix4d projection;  ///< eye coordinates to clip coordinates
    double diagonal = 1;         ///< of the mesh, mesh units
    double sight_edge = 0;       ///< as laplacian_lines::sight_edge() has it, mesh units
    double pixel_scale = 1;      ///< pixels of the viewport for one of the appearance
    double mark_pixels = 0;      ///< diameter of points or wires drawn on the surface
    DepthTexture depths{};       ///< of what hides lines
    /// Mesh coordinates to clip coordinates of all tiles that are put together to one picture, but
    /// for a move in its plane; none: it is not one. What is left out of lines is so the same in
    /// all of them, to the bit.
    std::optional<Eigen::Matrix4d> picture_to_clip{};
    /// By how much what is drawn may miss a line, pixels of the viewport; 0: by nothing. A quarter
    /// is not seen, and leaves a seventh of the segments of the dragon.
    double tolerance = 0.25;
};

/// Draws line sets with OpenGL over what is in the depth buffer. Holds a program and buffers for
/// each share group, which live as long as the group: no view that closes takes them from another.
/// Leaves OpenGL's state as it was. GUI thread only.
class LineRenderer {
public:
    LineRenderer();
    ~LineRenderer();

    /// Hands lines over to OpenGL, for drawing with the same appearance and placement: the points
    /// that are needed for what can be seen. No allocation while sets get no larger.
    /// @throws std::runtime_error if OpenGL cannot draw them; then draw() draws nothing
    void upload(const laplacian_lines::LineSet& lines, const LineAppearance& appearance,
                const LinePlacement& placement);
    /// Draws what was uploaded last into the current context's viewport. `clock` counts the draw
    /// calls themselves as drawing.
    /// @throws std::runtime_error if OpenGL cannot do it in this share group
    void draw(const LineAppearance& appearance, const LinePlacement& placement, RedrawClock& clock);

private:
    struct Objects;
    struct Pass;

    static Objects makeObjects();
    void drawHidden(const Objects& objects, const LineAppearance& appearance,
                    const LinePlacement& placement, RedrawClock& clock) const;
    void drawPass(const Objects& objects, const LinePlacement& placement, const Pass& pass,
                  RedrawClock& clock) const;

    std::unique_ptr<PerShareGroup<Objects>> objects_;
    std::vector<StreamPart> parts_;  ///< of what was uploaded last
};

}  // namespace line_renderer
