// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "laplacian_lines/line_set.h"
#include "line_renderer/line_appearance.h"
#include "line_renderer/redraw_clock.h"
#include "line_renderer/surface_depth.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;
struct StreamPart;

struct LinePlacement {
    Eigen::Matrix4d to_eye;      ///< mesh coordinates to eye coordinates
    Eigen::Matrix4d projection;  ///< eye coordinates to clip coordinates
    double diagonal = 1;         ///< of the mesh, mesh units
    double depth_bias_edge = 0;  ///< as laplacian_lines::depth_bias_edge() has it, mesh units
    double pixel_scale = 1;      ///< pixels of the viewport per pixel of the appearance
    double mark_pixels = 0;      ///< diameter of points or wires on the surface, as in the viewport
    DepthTexture depths{};       ///< of the surfaces that hide lines; without, nothing is seen
    /// For tiles of one picture: mesh coordinates to clip coordinates common to all tiles, up to a
    /// shift in the plane, so that all tiles drop the same points.
    std::optional<Eigen::Matrix4d> picture_to_clip{};
    /// Tolerance of the simplification of lines, pixels of the viewport. A quarter is invisible and
    /// leaves a seventh of the dragon's segments.
    double tolerance = 0.25;
};

/// Draws line sets with a depth test. Keeps OpenGL's state. One program and buffers per share
/// group, which outlive views that close. GUI thread only.
class LineRenderer {
public:
    LineRenderer();
    ~LineRenderer();

    /// Uploads lines, without points that make no visible difference, for drawing with the same
    /// appearance and placement. Does not allocate unless sets grow.
    /// @throws std::runtime_error if OpenGL cannot draw them; then draw() draws nothing
    void upload(const laplacian_lines::LineSet& lines, const LineAppearance& appearance,
                const LinePlacement& placement);
    /// Draws the last upload into the current viewport. `clock` counts the draw calls as drawing.
    /// @throws std::runtime_error if OpenGL cannot do it in this share group
    void draw(const LineAppearance& appearance, const LinePlacement& placement, RedrawClock& clock);

private:
    struct Objects;
    struct Pass;

    static Objects make_objects();
    void draw_hidden(const Objects& objects, const LineAppearance& appearance,
                     const LinePlacement& placement, RedrawClock& clock) const;
    void draw_pass(const Objects& objects, const LinePlacement& placement, const Pass& pass,
                   RedrawClock& clock) const;

    std::unique_ptr<PerShareGroup<Objects>> objects_;
    std::vector<StreamPart> parts_;                     ///< of what was uploaded last
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();  ///< of its points, mesh coordinates
};

}  // namespace line_renderer
