// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/picture_renderer.h"

#include "gl_state.h"
#include "per_share_group.h"
#include "shader_program.h"

namespace line_renderer {
namespace {

const char* const vertex_shader = R"(#version 120
uniform vec4 place;  // scale, twice; shift
varying vec2 at;
void main()
{
    at = vec2(0.5 + 0.5 * gl_Vertex.x, 0.5 - 0.5 * gl_Vertex.y);
    gl_Position = vec4(gl_Vertex.xy * place.xy + place.zw, 0.0, 1.0);
}
)";

const char* const fragment_shader = R"(#version 120
uniform sampler2D grays;
uniform vec4 ink;
varying vec2 at;
void main()
{
    gl_FragColor = vec4(ink.rgb, 1.0 - texture2D(grays, at).r);
}
)";

}  // namespace

struct PictureRenderer::Objects {
    ShaderProgram program{"The drawing cannot be shown", vertex_shader, fragment_shader};
    GLuint texture = 0;
    std::weak_ptr<const InkPicture> shown;  ///< in the texture

    void load(const InkPicturePointer& picture) {
        if (texture == 0) glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        if (picture == shown.lock()) return;
        glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, picture->size.x(), picture->size.y(), 0,
                     GL_LUMINANCE, GL_UNSIGNED_BYTE, picture->grays.data());
        glPopClientAttrib();
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
        shown = picture;
    }
};

PictureRenderer::PictureRenderer() : objects_(std::make_unique<PerShareGroup<Objects>>()) {}

PictureRenderer::~PictureRenderer() = default;

int PictureRenderer::largestSide() {
    GLint side = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
    return side;
}

void PictureRenderer::paint(const InkPicturePointer& picture, const QColor& ink,
                            const PicturePlace& place) {
    Objects& objects = objects_->current();
    const GlState state;
    glDisable(GL_DEPTH_TEST);
    objects.program.use();
    objects.load(picture);
    const auto scale = float(place.scale);
    objects.program.set(
        "place", Eigen::Vector4f(scale, scale, float(place.shift.x()), float(place.shift.y())));
    objects.program.set(
        "ink", Eigen::Vector4f(float(ink.redF()), float(ink.greenF()), float(ink.blueF()), 1));
    glRectf(-1, -1, 1, 1);
}

}  // namespace line_renderer
