// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/surface_renderer.h"

#include "gl_state.h"
#include "mean_scale.h"
#include "shader_program.h"
#include "surface_shaders.h"

namespace line_renderer {
namespace {

/// How far paint may come before the surface to cover MeshLab's wires and points, in diagonals.
constexpr double least_move = 0.0005;
constexpr double greatest_move = 0.03;

void setColor(GLint location, const QColor& color) {
    glUniform4f(location, float(color.redF()), float(color.greenF()), float(color.blueF()), 1);
}

}  // namespace

SurfaceRenderer::Program& SurfaceRenderer::programOfCurrentGroup() {
    const ShareGroup group = currentShareGroup();
    const auto [place, is_new] = groups_.try_emplace(group);
    Program& program = place->second;
    if (!is_new) return program;
    whenGone(group, &receiver_, [this, group] { groups_.erase(group); });
    if (!GLEW_VERSION_2_0) {
        program.failure = "shaders (OpenGL 2.0) are not available";
        return program;
    }
    program.id =
        buildShaderProgram(surface_vertex_shader, surface_fragment_shader, {}, program.failure);
    if (!program.id) return program;
    program.paper = glGetUniformLocation(program.id, "paper");
    program.shade = glGetUniformLocation(program.id, "shade");
    program.tones = glGetUniformLocation(program.id, "tones");
    program.nearer = glGetUniformLocation(program.id, "nearer");
    program.surface_depth = glGetUniformLocation(program.id, "surface_depth");
    program.texel = glGetUniformLocation(program.id, "texel");
    return program;
}

std::string SurfaceRenderer::paint(const SurfaceLayer& layer, const SurfaceAppearance& appearance,
                                   const Eigen::Matrix4d& to_eye, const DepthTexture& depth,
                                   SurfaceBuffers& buffers) {
    const Program& program = programOfCurrentGroup();
    if (!program.id) return "The surface cannot be painted: " + program.failure;

    const LineGlState state;
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
    return {};
}

}  // namespace line_renderer
