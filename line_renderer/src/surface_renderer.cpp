// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/surface_renderer.h"

#include "gl_state.h"
#include "line_stream.h"
#include "per_share_group.h"
#include "shaders.h"

namespace line_renderer {
namespace {

/// How far paint may move to cover wires and points, in diagonals.
constexpr double least_move = 0.0005;
constexpr double greatest_move = 0.03;

void setColor(GLint location, const QColor& color) {
    glUniform4f(location, float(color.redF()), float(color.greenF()), float(color.blueF()), 1);
}

}  // namespace

struct SurfaceRenderer::Program {
    GLuint id = buildShaderProgram("The surface cannot be painted", surface_vertex_shader,
                                   surface_fragment_shader);
    GLint paper = glGetUniformLocation(id, "paper");
    GLint shade = glGetUniformLocation(id, "shade");
    GLint tones = glGetUniformLocation(id, "tones");
    GLint nearer = glGetUniformLocation(id, "nearer");
    GLint surface_depth = glGetUniformLocation(id, "surface_depth");
    GLint texel = glGetUniformLocation(id, "texel");
};

SurfaceRenderer::SurfaceRenderer() : programs_(std::make_unique<PerShareGroup<Program>>()) {}

SurfaceRenderer::~SurfaceRenderer() = default;

void SurfaceRenderer::paint(const SurfaceLayer& layer, const SurfaceAppearance& appearance,
                            const Eigen::Matrix4d& to_eye, const DepthTexture& depth,
                            SurfaceBuffers& buffers) {
    const Program& program = programs_->current();
    const GlState state;
    glDisable(GL_BLEND);
    glUseProgram(program.id);
    setColor(program.paper, appearance.paper);
    setColor(program.shade, appearance.shade);
    const bool is_toon = appearance.style == SurfaceAppearance::Toon;
    glUniform1f(program.tones, is_toon ? float(appearance.tones) : 1);
    const double diagonal = layer.diagonal * meanScale(to_eye);
    glUniform2f(program.nearer, float(least_move * diagonal), float(greatest_move * diagonal));
    const bool is_needed = !depth.is_complete;
    glBindTexture(GL_TEXTURE_2D, is_needed ? depth.id : 0);
    glUniform1i(program.surface_depth, 0);
    const Eigen::Vector2f texel = is_needed ? depth.texel : Eigen::Vector2f(0, 0);
    glUniform2fv(program.texel, 1, texel.data());
    buffers.draw(layer);
}

}  // namespace line_renderer
