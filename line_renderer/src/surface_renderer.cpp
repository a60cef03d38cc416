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

}  // namespace

struct SurfaceRenderer::Program {
    GLuint id = buildShaderProgram("The surface cannot be painted", surface_vertex_shader,
                                   surface_fragment_shader);
    GLint is_toon = glGetUniformLocation(id, "is_toon");
    GLint nearer = glGetUniformLocation(id, "nearer");
    GLint surface_depth = glGetUniformLocation(id, "surface_depth");
    GLint texel = glGetUniformLocation(id, "texel");
};

SurfaceRenderer::SurfaceRenderer() : programs_(std::make_unique<PerShareGroup<Program>>()) {}

SurfaceRenderer::~SurfaceRenderer() = default;

void SurfaceRenderer::paint(const SurfaceLayer& layer, SurfaceStyle style,
                            const Eigen::Matrix4d& to_eye, const DepthTexture& depth,
                            SurfaceBuffers& buffers) {
    const Program& program = programs_->current();
    const GlState state;
    glDisable(GL_BLEND);
    glUseProgram(program.id);
    glUniform1i(program.is_toon, style == SurfaceStyle::Toon);
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
