// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl_test.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <stdexcept>

using line_renderer::LinePlacement;
using line_renderer::SurfaceLayer;
using line_renderer::SurfacePointer;

Canvas::Canvas(int samples) {
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const auto attach = [samples](GLuint& buffer, GLenum format, GLenum place) {
        glGenRenderbuffers(1, &buffer);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    };
    attach(colors_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(depths_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("There is no framebuffer of this kind.");
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(projection().data());
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glEnable(GL_DEPTH_TEST);
    clear();
}

Canvas::~Canvas() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &colors_);
    glDeleteRenderbuffers(1, &depths_);
}

void Canvas::clear(float alpha, const QColor& color) const {
    glClearColor(float(color.redF()), float(color.greenF()), float(color.blueF()), alpha);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Canvas::put_depth(int x, int y, int columns, int rows, double z) const {
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, columns, rows);
    glClearDepth(depth_of(z));
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

QImage Canvas::picture() const {
    QImage picture(width, height, QImage::Format_RGBA8888);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture.bits());
    return picture.mirrored();
}

Eigen::Matrix4d Canvas::projection() {
    Eigen::Matrix4d result = Eigen::Vector4d(2.0 / width, 2.0 / height, -1, 1).asDiagonal();
    result.topRightCorner<2, 1>() << -1, -1;
    return result;
}

LinePlacement Canvas::placement() {
    LinePlacement result;
    result.to_eye = Eigen::Matrix4d::Identity();
    result.projection = projection();
    return result;
}

double ink_of_column(const QImage& picture, int x) {
    double ink = 0;
    for (int y = 0; y < picture.height(); ++y)
        ink += 1 - picture.pixelColor(x, y).greenF();
    return ink;
}

double ink_of(const QImage& picture) {
    double ink = 0;
    for (int x = 0; x < picture.width(); ++x)
        ink += ink_of_column(picture, x);
    return ink;
}

QColor color_at(const QImage& picture, int x, int y) {
    return picture.pixelColor(x, picture.height() - 1 - y);
}

Rectangles& Rectangles::add(double x, double y, double columns, double rows, double z,
                            const Eigen::Vector3f& normal) {
    const auto first = std::uint32_t(surface_.vertices.size());
    for (const auto& [right, up] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
        surface_.vertices.push_back(
            {Eigen::Vector3d(x + right * columns, y + up * rows, z).cast<float>(), normal});
    surface_.triangles.push_back({first, first + 1, first + 2});
    surface_.triangles.push_back({first, first + 2, first + 3});
    return *this;
}

SurfacePointer Rectangles::surface() const {
    return std::make_shared<line_renderer::Surface>(surface_);
}

SurfaceLayer layer_of(const SurfacePointer& surface) {
    SurfaceLayer layer;
    layer.surface = surface;
    layer.diagonal = 1;
    return layer;
}

struct GlContext::Data {
    QOffscreenSurface surface;
    QOpenGLContext context;
};

GlContext::GlContext(const GlContext* partner) : data_(std::make_unique<Data>()) {
    if (partner) data_->context.setShareContext(&partner->data_->context);
    if (!data_->context.create()) throw std::runtime_error("There is no OpenGL here.");
    data_->surface.setFormat(data_->context.format());
    data_->surface.create();
    make_current();
}

GlContext::~GlContext() = default;

void GlContext::make_current() {
    if (!data_->context.makeCurrent(&data_->surface))
        throw std::runtime_error("OpenGL cannot be used here.");
}

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const QGuiApplication program(argc, argv);
    return RUN_ALL_TESTS();
}
