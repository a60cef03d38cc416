// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl_context.h"
#include "line_renderer/surface_depth.h"
#include "made_up_lines.h"

class LineTest : public GlTest {
protected:
    /// Hidden by the depth buffer.
    QImage drawn(const laplacian_lines::LineSet& lines,
                 const line_renderer::LineAppearance& appearance,
                 line_renderer::LinePlacement placement = Canvas::placement()) {
        depth_.forgetDepthBuffer();
        placement.depths = depth_.copy();
        line_renderer::RedrawClock clock;
        renderer_.upload(lines, appearance, placement);
        renderer_.draw(appearance, placement, clock);
        return canvas_.picture();
    }

    line_renderer::SurfaceDepth depth_;
    line_renderer::LineRenderer renderer_;
};

inline line_renderer::LineAppearance blackLines(double width) {
    line_renderer::LineAppearance appearance;
    appearance.looks.fill({Qt::black, width});
    return appearance;
}
