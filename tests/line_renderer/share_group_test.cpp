// SPDX-License-Identifier: GPL-3.0-or-later
// Objects of a share group are made once, used by all its contexts, and forgotten with it.
#include "gl_test.h"
#include "line_renderer/surface_renderer.h"

namespace {

struct Renderers {
    line_renderer::SurfaceDepth depth;
    line_renderer::SurfaceBuffers buffers;
    line_renderer::SurfaceRenderer surfaces;
    line_renderer::LineRenderer lines;
    line_renderer::SurfacePointer surface = Rectangles().add(20, 20, 90, 70, 0).surface();

    QImage picture() {
        const Canvas canvas;
        canvas.clear(1, Qt::yellow);
        line_renderer::LinePlacement placement = Canvas::placement();
        depth.forget_depth_buffer();
        placement.depths = depth.copy();
        surfaces.paint(layer_of(surface), {}, placement.to_eye, placement.depths, buffers);
        line_renderer::RedrawClock clock;
        lines.upload(one_line({{9, 9, 0}, {90, 80, 0}}), black_lines(3), placement);
        lines.draw(black_lines(3), placement, clock);
        return canvas.picture();
    }
};

TEST(ShareGroups, AreAllDrawnIn) {
    Renderers renderers;
    auto first = std::make_unique<GlContext>();
    const QImage expected = renderers.picture();
    ASSERT_EQ(color_at(expected, 100, 30), QColor(Qt::white));
    ASSERT_LT(color_at(expected, 9, 9).greenF(), 0.1);
    auto partner = std::make_unique<GlContext>(first.get());
    EXPECT_EQ(renderers.picture(), expected) << "shared";
    GlContext other;
    EXPECT_EQ(renderers.picture(), expected) << "not shared";
    first.reset();
    partner->make_current();
    EXPECT_EQ(renderers.picture(), expected) << "shared with one that is gone";
    partner.reset();
    other.make_current();
    EXPECT_EQ(renderers.picture(), expected) << "beside a group that is gone";
    const GlContext next;
    EXPECT_EQ(renderers.picture(), expected) << "after a group that is gone";
}

int buffers_in_use() {
    int count = 0;
    for (GLuint name = 1; name < 100; ++name)
        count += glIsBuffer(name);
    return count;
}

using SurfaceBuffersTest = GlTest;

TEST_F(SurfaceBuffersTest, AreFreedWhenTheirSurfaceIsGone) {
    const Rectangles rectangles = Rectangles().add(20, 20, 90, 70, 0);
    line_renderer::SurfaceBuffers buffers;
    line_renderer::SurfacePointer gone = rectangles.surface();
    const line_renderer::SurfacePointer kept = rectangles.surface();
    for (int time = 0; time < 2; ++time)
        buffers.draw(layer_of(gone));
    ASSERT_EQ(buffers_in_use(), 2) << "vertices and triangles, handed over once";
    gone.reset();
    for (int time = 0; time < 2; ++time)
        buffers.draw(layer_of(kept));
    EXPECT_EQ(buffers_in_use(), 2);
}

}  // namespace
