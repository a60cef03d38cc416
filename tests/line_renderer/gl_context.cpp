// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl_context.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <stdexcept>

struct GlContext::Data {
    QOffscreenSurface surface;
    QOpenGLContext context;
};

GlContext::GlContext(const GlContext* partner) : data_(std::make_unique<Data>()) {
    if (partner) data_->context.setShareContext(&partner->data_->context);
    if (!data_->context.create()) throw std::runtime_error("There is no OpenGL here.");
    data_->surface.setFormat(data_->context.format());
    data_->surface.create();
    makeCurrent();
}

GlContext::~GlContext() = default;

void GlContext::makeCurrent() {
    if (!data_->context.makeCurrent(&data_->surface))
        throw std::runtime_error("OpenGL cannot be used here.");
}

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const QGuiApplication program(argc, argv);
    return RUN_ALL_TESTS();
}
