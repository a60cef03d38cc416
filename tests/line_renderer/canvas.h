// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/gl.h>

#include <Eigen/Core>
#include <QImage>

#include "line_renderer/line_renderer.h"
#include "line_renderer/surface.h"

/// A framebuffer to draw into, with colors, alpha and depths, bound in the current context as long
/// as it lives. Coordinates are pixels from the lower left, as long as the camera is not changed; z
/// is towards the eye, which is infinitely far, and all within -1..1 is seen.
class Canvas {
public:
    static constexpr int width = 160, height = 120;

    /// Without `samples` each pixel has one color.
    explicit Canvas(int samples = 0);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// White and empty, opaque unless told otherwise.
    void clear(float alpha = 1) const;
    /// Fills a part of the depth buffer with the depth of a z.
    void putDepth(int x, int y, int columns, int rows, double z) const;

    QImage picture() const;

    static Eigen::Matrix4d projection();
    /// For drawing lines whose mesh coordinates are those of the canvas.
    static line_renderer::LinePlacement placement();
    /// What putDepth(z) writes, 0..1.
    static float depthOf(double z) { return float(0.5 - 0.5 * z); }

private:
    GLuint framebuffer_ = 0, colors_ = 0, depths_ = 0;
};

/// How dark a row or column of a picture is: the sum of its pixels, white 0 and black 1.
double inkOfColumn(const QImage& picture, int x);
double inkOfRow(const QImage& picture, int y);
double inkOf(const QImage& picture);

/// The color of a pixel, counted from the lower left.
QColor colorAt(const QImage& picture, int x, int y);

/// A surface of rectangles that face the eye, whatever their normals say.
class Rectangles {
public:
    void add(double x, double y, double columns, double rows, double z,
             const Eigen::Vector3f& normal = {0, 0, 1});
    line_renderer::SurfacePointer surface() const;

private:
    line_renderer::Surface surface_;
};

/// In its place as it is. The surface must live as long as it is to be drawn.
line_renderer::SurfaceLayer layerOf(const line_renderer::SurfacePointer& surface);

/// Has a function or a value be another one as long as it lives.
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
