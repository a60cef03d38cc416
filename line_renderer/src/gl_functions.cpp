// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl_functions.h"

#include <QOpenGLContext>
#include <cstdio>

namespace line_renderer {
namespace {

GlFeatures current_features() {
    int major = 0, minor = 0;
    if (const auto* text = reinterpret_cast<const char*>(glGetString(GL_VERSION)))
        std::sscanf(text, "%d.%d", &major, &minor);
    const int version = 10 * major + minor;
    const auto has = [](const char* extension) {
        const QOpenGLContext* context = QOpenGLContext::currentContext();
        return context && context->hasExtension(extension);
    };
    const bool is_3_0 = version >= 30;
    GlFeatures features;
    features.shaders = version >= 20;
    features.array_objects = is_3_0 || has("GL_ARB_vertex_array_object");
    features.framebuffers = is_3_0 || has("GL_ARB_framebuffer_object");
    features.buffer_ranges = is_3_0 || has("GL_ARB_map_buffer_range");
    features.instancing = version >= 33;
    features.old_instancing =
        features.shaders && has("GL_ARB_instanced_arrays") && has("GL_ARB_draw_instanced");
    return features;
}

}  // namespace

void (*find_gl_function(const char* name))() {
    const QOpenGLContext* context = QOpenGLContext::currentContext();
    return context ? context->getProcAddress(name) : nullptr;
}

GlFeatures& gl_features() {
    static GlFeatures features = current_features();
    return features;
}

}  // namespace line_renderer
