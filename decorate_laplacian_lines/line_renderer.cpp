// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer.h"

#include <cstddef>

#include "gl_state.h"
#include "instancing.h"
#include "mean_scale.h"

namespace {

/// Hidden lines: alpha of faint ones; of dashed ones pixels of a dash, and with the gap after it.
constexpr double faint_alpha = 0.25;
constexpr float dash_pixels = 5;
constexpr float dash_period = 9;
/// How much deeper than a line that is left out one has to lie to be drawn as hidden: otherwise the
/// covered halves of seen contours would be.
constexpr double hidden_depth = 12;

LineRadii radii(const LineAppearance& appearance) {
    LineRadii result;
    result.laplacian = float(appearance.width / 2);
    // twice as much: a contour lies where the surface falls away, which hides its inner half
    result.contour = float(appearance.contour_factor * appearance.width);
    return result;
}

Eigen::Vector2f halfViewport() {
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    return {float(viewport[2]) / 2, float(viewport[3]) / 2};
}

void setColor(GLint location, const QColor& color, double alpha) {
    glUniform4f(location, float(color.redF()), float(color.greenF()), float(color.blueF()),
                float(color.alphaF() * alpha));
}

void setColors(const LineProgram& program, const LineAppearance& appearance, double alpha) {
    setColor(program.color, appearance.color, alpha);
    setColor(program.contour_color, appearance.contour_color, alpha);
}

void setUniforms(const LineProgram& program, const LineAppearance& appearance,
                 const LinePlacement& placement) {
    const Eigen::Matrix4f to_eye = placement.to_eye.cast<float>();
    const Eigen::Matrix4f projection = placement.projection.cast<float>();
    glUniformMatrix4fv(program.to_eye, 1, GL_FALSE, to_eye.data());
    glUniformMatrix4fv(program.projection, 1, GL_FALSE, projection.data());
    glUniform2fv(program.half_viewport, 1, halfViewport().data());
    glUniform1f(program.depth_bias, float(placement.depth_bias * meanScale(placement.to_eye)));
    glUniform1f(program.contour_share, 1);
    setColors(program, appearance, 1);
    glUniform2f(program.dash, 0, 0);
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
constexpr LineProgram::Attribute per_segment[] = {LineProgram::Before,    LineProgram::Start,
                                                  LineProgram::End,       LineProgram::After,
                                                  LineProgram::StartLook, LineProgram::EndLook};

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

void LineRenderer::bindStream(const GroupObjects& objects) {
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
    const std::size_t look = offsetof(StreamPoint, opacity);
    pointAttribute(LineProgram::StartLook, 3, sizeof(StreamPoint), sizeof(StreamPoint) + look, 1);
    pointAttribute(LineProgram::EndLook, 3, sizeof(StreamPoint), 2 * sizeof(StreamPoint) + look, 1);
}

void LineRenderer::drawSegments() {
    drawInstanced(GL_TRIANGLE_STRIP, 4, GLsizei(stream_.size()) - 3);
}

void LineRenderer::drawHidden(const LineProgram& program, const LineAppearance& appearance,
                              const LinePlacement& placement) {
    const bool is_dashed = appearance.hidden == HiddenLines::Dashed;
    LinePlacement deeper = placement;
    deeper.depth_bias *= hidden_depth;
    setUniforms(program, appearance, deeper);
    setColors(program, appearance, is_dashed ? 1 : faint_alpha);
    glUniform1f(program.contour_share, 0.5f);  // the inner half is not covered here
    if (is_dashed) glUniform2f(program.dash, dash_pixels, dash_period);
    glDepthFunc(GL_GREATER);
    drawSegments();
    glDepthFunc(GL_LEQUAL);
}

std::string LineRenderer::draw(const laplacian_lines::LineSet& lines,
                               const LineAppearance& appearance, const LinePlacement& placement) {
    const GroupObjects& objects = objectsOfCurrentGroup();
    if (!objects.program.id) return "Lines cannot be drawn: " + objects.program.failure;
    makeStream(lines, radii(appearance), stream_);
    if (stream_.empty()) return {};
    if (appearance.hidden == HiddenLines::Dashed) {
        const Eigen::Matrix4d to_clip = placement.projection * placement.to_eye;
        measureLines({to_clip.cast<float>(), halfViewport()}, stream_);
    }

    const LineGlState state;
    glUseProgram(objects.program.id);
    bindStream(objects);
    if (appearance.hidden != HiddenLines::LeftOut)
        drawHidden(objects.program, appearance, placement);
    setUniforms(objects.program, appearance, placement);
    drawSegments();
    for (LineProgram::Attribute attribute : per_segment)
        setDivisor(attribute, 0);  // not saved by all drivers
    return {};
}
