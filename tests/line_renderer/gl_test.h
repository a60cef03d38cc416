// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/gl.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <QColor>
#include <QImage>
#include <memory>

#include "line_renderer/line_renderer.h"
#include "line_renderer/surface_depth.h"
#include "synthetic_lines.h"

/// A framebuffer with colors, alpha and depths, bound in the current context while it lives.
/// Coordinates are pixels from the lower left until the camera changes; z in -1..1 points to an
/// infinitely far eye.
class Canvas {
public:
    static constexpr int width = 160, height = 120;

    explicit Canvas(int samples = 0);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    void clear(float alpha = 1, const QColor& color = Qt::white) const;
    /// Fills part of the depth buffer.
    void put_depth(int x, int y, int columns, int rows, double z) const;

    QImage picture() const;

    static Eigen::Matrix4d projection();
    /// Mesh coordinates are those of the canvas.
    static line_renderer::LinePlacement placement();
    /// As put_depth(z) writes it, 0..1.
    static float depth_of(double z) { return float(0.5 - 0.5 * z); }

private:
    GLuint framebuffer_ = 0, colors_ = 0, depths_ = 0;
};

/// Sum of darkness, white 0 and black 1.
double ink_of_column(const QImage& picture, int x);
double ink_of(const QImage& picture);

/// From the lower left.
QColor color_at(const QImage& picture, int x, int y);

/// Rectangles that face the eye, with any normals.
class Rectangles {
public:
    Rectangles& add(double x, double y, double columns, double rows, double z,
                    const Eigen::Vector3f& normal = {0, 0, 1});
    line_renderer::SurfacePointer surface() const;

private:
    line_renderer::Surface surface_;
};

/// Untransformed, of diagonal 1. Draws nothing once the surface is gone.
line_renderer::SurfaceLayer layer_of(const line_renderer::SurfacePointer& surface);

/// Replaces a function or value while it lives.
template <class Function>
class Replaced {
public:
    Replaced(Function& function, Function other) : function_(function), before_(function) {
        function = other;
    }
    ~Replaced() { function_ = before_; }
    Replaced(const Replaced&) = delete;
    Replaced& operator=(const Replaced&) = delete;

    Function before() const { return before_; }

private:
    Function& function_;
    Function before_;
};

/// Without a window; current until another one is.
class GlContext {
public:
    /// In its own share group, or `partner`'s. @throws std::runtime_error if there is no OpenGL
    explicit GlContext(const GlContext* partner = nullptr);
    ~GlContext();

    void make_current();

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

/// Draws on a canvas in its own context.
class GlTest : public testing::Test {
protected:
    GlContext context_;
    Canvas canvas_;
};

class LineTest : public GlTest {
protected:
    /// Hidden by the placement's depths, or else by the depth buffer.
    QImage drawn(const laplacian_lines::LineSet& lines,
                 const line_renderer::LineAppearance& appearance,
                 line_renderer::LinePlacement placement = Canvas::placement()) {
        depth_.forget_depth_buffer();
        if (placement.depths.id == 0) placement.depths = depth_.copy();
        line_renderer::RedrawClock clock;
        renderer_.upload(lines, appearance, placement);
        renderer_.draw(appearance, placement, clock);
        return canvas_.picture();
    }

    line_renderer::SurfaceDepth depth_;
    line_renderer::LineRenderer renderer_;
};

inline line_renderer::LineAppearance black_lines(double width) {
    line_renderer::LineAppearance appearance;
    appearance.looks.fill({Qt::black, width});
    return appearance;
}
