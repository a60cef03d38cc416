// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer.h"

#include "gl_state.h"
#include "instancing.h"
#include "mean_scale.h"

namespace {

LineRadii radii(const LineAppearance& appearance) {
    LineRadii result;
    result.laplacian = float(appearance.width / 2);
    // twice as much: a contour lies where the surface falls away, which hides its inner half
    result.contour = float(appearance.contour_factor * appearance.width);
    return result;
}

void setUniforms(const LineProgram& program, const LineAppearance& appearance,
                 const LinePlacement& placement) {
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    const Eigen::Matrix4f to_eye = placement.to_eye.cast<float>();
    const Eigen::Matrix4f projection = placement.projection.cast<float>();
    glUniformMatrix4fv(program.to_eye, 1, GL_FALSE, to_eye.data());
    glUniformMatrix4fv(program.projection, 1, GL_FALSE, projection.data());
    glUniform2f(program.half_viewport, float(viewport[2]) / 2, float(viewport[3]) / 2);
    glUniform1f(program.depth_bias, float(placement.depth_bias * meanScale(placement.to_eye)));
    glUniform4f(program.color, float(appearance.color.redF()), float(appearance.color.greenF()),
                float(appearance.color.blueF()), float(appearance.color.alphaF()));
}

GLuint makeCornerBuffer() {
    constexpr float corners[] = {0, -1, 1, -1, 0, 1, 1, 1};  // a triangle strip
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    return buffer;
}

/// Reads an attribute from the buffer that is bound. `divisor` 1: one value a segment.
void pointAttribute(LineProgram::Attribute attribute, GLint floats, GLsizei stride,
                    std::size_t offset, GLuint divisor) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribPointer(attribute, floats, GL_FLOAT, GL_FALSE, stride,
                          reinterpret_cast<const void*>(offset));
    setDivisor(attribute, divisor);
}

/// The segment attributes are four windows onto one array, each a point further.
constexpr LineProgram::Attribute windows[] = {LineProgram::Before, LineProgram::Start,
                                              LineProgram::End, LineProgram::After};

}  // namespace

LineRenderer::GroupObjects& LineRenderer::objectsOfCurrentGroup() {
    const ShareGroup group = currentShareGroup();
    const auto [place, is_new] = groups_.try_emplace(group);
    GroupObjects& objects = place->second;
    if (is_new) {
        whenGone(group, &receiver_, [this, group] { groups_.erase(group); });
        if (!canDrawInstanced()) {
            objects.program.failure = "instanced drawing (OpenGL 3.3) is not available";
            return objects;
        }
        const LineGlState state;  // for the buffer binding
        objects.program = buildLineProgram();
        objects.corners = makeCornerBuffer();
        glGenBuffers(1, &objects.stream);
    }
    return objects;
}

void LineRenderer::drawStream(const GroupObjects& objects) {
    glBindBuffer(GL_ARRAY_BUFFER, objects.corners);
    pointAttribute(LineProgram::Corner, 2, 0, 0, 0);

    const auto bytes = GLsizeiptr(stream_.size() * sizeof(StreamPoint));
    glBindBuffer(GL_ARRAY_BUFFER, objects.stream);
    // New storage first: the driver need not wait for the last frame to be done with the old one.
    glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, stream_.data());
    std::size_t offset = 0;
    for (LineProgram::Attribute window : windows) {
        pointAttribute(window, 4, sizeof(StreamPoint), offset, 1);
        offset += sizeof(StreamPoint);
    }
    drawInstanced(GL_TRIANGLE_STRIP, 4, GLsizei(stream_.size()) - 3);
    for (LineProgram::Attribute window : windows)
        setDivisor(window, 0);  // not saved by all drivers
}

std::string LineRenderer::draw(const laplacian_lines::LineSet& lines,
                               const LineAppearance& appearance, const LinePlacement& placement) {
    const GroupObjects& objects = objectsOfCurrentGroup();
    if (!objects.program.id) return "Lines cannot be drawn: " + objects.program.failure;
    makeStream(lines, radii(appearance), stream_);
    if (stream_.empty()) return {};

    const LineGlState state;
    glUseProgram(objects.program.id);
    setUniforms(objects.program, appearance, placement);
    drawStream(objects);
    return {};
}
