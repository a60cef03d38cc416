// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/picture_renderer.h"

#include "gl_state.h"
#include "per_share_group.h"
#include "shader_program.h"

namespace line_renderer {
namespace {

const char* const kVertexShader = R"(#version 120
varying vec2 at;
void main()
{
    at = vec2(0.5 + 0.5 * gl_Vertex.x, 0.5 - 0.5 * gl_Vertex.y);
    gl_Position = vec4(gl_Vertex.xy, 0.0, 1.0);
}
)";

const char* const kFragmentShader = R"(#version 120
uniform sampler2D grays;
uniform vec4 ink;
varying vec2 at;
void main()
{
    gl_FragColor = vec4(ink.rgb, ink.a * (1.0 - texture2D(grays, at).r));
}
)";

}  // namespace

struct PictureRenderer::Objects {
    ShaderProgram program{"The drawing cannot be shown", kVertexShader, kFragmentShader};
    GLuint texture = 0;
};

PictureRenderer::PictureRenderer() : objects_(std::make_unique<PerShareGroup<Objects>>()) {}

PictureRenderer::~PictureRenderer() = default;

void PictureRenderer::paint(const InkPicture& picture, const std::vector<QColor>& colors,
                            const Eigen::Vector2i& corner) {
    Objects& objects = objects_->current();
    const auto viewport = current_viewport();
    const GlState state;
    glDisable(GL_DEPTH_TEST);
    objects.program.use();
    if (objects.texture == 0) glGenTextures(1, &objects.texture);
    glBindTexture(GL_TEXTURE_2D, objects.texture);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (std::size_t i = 0; i < picture.inks.size(); ++i) {
        glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, picture.size.x());
        glPixelStorei(GL_UNPACK_SKIP_PIXELS, corner.x());
        glPixelStorei(GL_UNPACK_SKIP_ROWS, corner.y());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, viewport[2], viewport[3], 0, GL_LUMINANCE,
                     GL_UNSIGNED_BYTE, picture.inks[i].data());
        glPopClientAttrib();
        const QColor& color = colors.at(i);
        objects.program.set("ink", Eigen::Vector4f(float(color.redF()), float(color.greenF()),
                                                   float(color.blueF()), float(color.alphaF())));
        glRectf(-1, -1, 1, 1);
    }
}

}  // namespace line_renderer
