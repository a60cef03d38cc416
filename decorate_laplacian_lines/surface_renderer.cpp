// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_renderer.h"

#include "gl_state.h"
#include "shader_program.h"
#include "surface_shaders.h"

namespace {

/// How far paint may come before the surface to cover MeshLab's wires and points, in diagonals.
constexpr double least_move = 0.0005;
constexpr double greatest_move = 0.03;

/// Fills a new buffer and leaves it bound.
template <class T>
GLuint makeBuffer(GLenum target, const std::vector<T>& content) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, GLsizeiptr(content.size() * sizeof(T)), content.data(), GL_STATIC_DRAW);
    return buffer;
}

template <class Map>
void freeExpired(Map& buffers) {
    for (auto entry = buffers.begin(); entry != buffers.end();) {
        if (!entry->first.expired()) {
            ++entry;
            continue;
        }
        glDeleteBuffers(1, &entry->second.vertices);
        glDeleteBuffers(1, &entry->second.triangles);
        entry = buffers.erase(entry);
    }
}

const void* offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

void setColor(GLint location, const QColor& color) {
    glUniform4f(location, float(color.redF()), float(color.greenF()), float(color.blueF()), 1);
}

}  // namespace

SurfaceRenderer::GroupObjects& SurfaceRenderer::objectsOfCurrentGroup() {
    const ShareGroup group = currentShareGroup();
    const auto [place, is_new] = groups_.try_emplace(group);
    if (is_new) whenGone(group, &receiver_, [this, group] { groups_.erase(group); });
    freeExpired(place->second.buffers);
    return place->second;
}

void SurfaceRenderer::drawFaces(const SurfacePointer& surface, const Eigen::Matrix4d& layer) {
    const auto [entry, is_new] = objectsOfCurrentGroup().buffers.try_emplace(surface);
    Buffers& buffers = entry->second;
    if (is_new) {
        buffers.vertices = makeBuffer(GL_ARRAY_BUFFER, surface->vertices);
        buffers.triangles = makeBuffer(GL_ELEMENT_ARRAY_BUFFER, surface->triangles);
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffers.vertices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.triangles);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(SurfaceVertex), offset(0));
    glNormalPointer(GL_FLOAT, sizeof(SurfaceVertex), offset(sizeof(Eigen::Vector3f)));

    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glMultMatrixd(layer.data());
    glDrawElements(GL_TRIANGLES, GLsizei(3 * surface->triangles.size()), GL_UNSIGNED_INT, nullptr);
    glPopMatrix();
}

void SurfaceRenderer::drawDepth(const SurfacePointer& surface, const Eigen::Matrix4d& layer) {
    const LineGlState state;
    // the fixed pipeline, as in MeshLab's own drawing, so that depths are the same
    glUseProgram(0);
    glDisable(GL_BLEND);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_LIGHTING);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    // behind wires and points, and behind what later decorations draw on the surface
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 1);
    drawFaces(surface, layer);
}

void SurfaceRenderer::build(Program& program) {
    if (!GLEW_VERSION_2_0) {
        program.failure = "shaders (OpenGL 2.0) are not available";
        return;
    }
    program.id =
        buildShaderProgram(surface_vertex_shader, surface_fragment_shader, {}, program.failure);
    if (!program.id) return;
    program.paper = glGetUniformLocation(program.id, "paper");
    program.shade = glGetUniformLocation(program.id, "shade");
    program.tones = glGetUniformLocation(program.id, "tones");
    program.nearer = glGetUniformLocation(program.id, "nearer");
}

std::string SurfaceRenderer::paint(const SurfacePointer& surface, const Eigen::Matrix4d& layer,
                                   const SurfaceAppearance& appearance, double diagonal) {
    Program& program = objectsOfCurrentGroup().program;
    if (!program.id && program.failure.empty()) build(program);
    if (!program.id) return "The surface cannot be painted: " + program.failure;

    const LineGlState state;
    glDisable(GL_BLEND);
    glUseProgram(program.id);
    setColor(program.paper, appearance.paper);
    setColor(program.shade, appearance.shade);
    const bool is_toon = appearance.style == SurfaceAppearance::Toon;
    glUniform1f(program.tones, is_toon ? float(appearance.tones) : 1);
    glUniform2f(program.nearer, float(least_move * diagonal), float(greatest_move * diagonal));
    drawFaces(surface, layer);
    return {};
}
