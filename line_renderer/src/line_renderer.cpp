// SPDX-License-Identifier: GPL-3.0-or-later
// Draws lines by instances of a quad, one for each segment (line_shaders.cpp): first the hidden
// lines, if they are wanted, as what is behind the surface, then those that are seen.
#include "line_renderer/line_renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>

#include "gl_functions.h"
#include "gl_state.h"
#include "laplacian_lines/view.h"
#include "line_buffers.h"
#include "line_shaders.h"
#include "line_stream.h"
#include "per_share_group.h"
#include "shader_program.h"

namespace line_renderer {
namespace {

/// A line is visible if the surface is behind it there or so many pixels to either side: less than
/// half an outline's usual width, which hides the parts below it.
constexpr double kToSide = 1.5;

/// Of a square, in its sides.
constexpr double kHalfDiagonal = 0.7072;

/// Hidden lines: length of a dash and its period, pixels.
constexpr double kDashPixels = 5;
constexpr double kDashPeriod = 9;
/// Least distance of hidden lines behind the surface, in depth biases; nearer are pieces along
/// outlines.
constexpr double kHiddenDepth = 4;

template <class Value>
using PerLook = std::array<Value, laplacian_lines::kLineKindCount>;
static_assert(laplacian_lines::kLineKindCount <= kMostLooks, "the shaders need longer arrays");

Eigen::Vector2f half_viewport() {
    const auto viewport = current_viewport();
    return Eigen::Vector2f(float(viewport[2]), float(viewport[3])) / 2;
}

void set_colors(const ShaderProgram& program, const LineAppearance& appearance, double alpha) {
    PerLook<Eigen::Vector4f> colors;
    for (std::size_t look = 0; look < colors.size(); ++look) {
        const QColor& color = appearance.looks[look].color;
        colors[look] << float(color.redF()), float(color.greenF()), float(color.blueF()),
            float(color.alphaF() * alpha);
    }
    program.set("colors", colors);
}

void set_shares_within(const ShaderProgram& program, const LineAppearance& appearance) {
    PerLook<float> shares;
    for (std::size_t look = 0; look < shares.size(); ++look)
        shares[look] = float(appearance.looks[look].share_within);
    program.set("shares_within", shares);
}

void set_depth_biases(const ShaderProgram& program, const LinePlacement& placement, double factor) {
    PerLook<float> biases;
    for (std::size_t look = 0; look < biases.size(); ++look)
        biases[look] = float(factor * line_clearance(look, placement));
    program.set("depth_biases", biases);
}

/// For both seen and hidden lines; binds the depths' texture.
void set_placement(const ShaderProgram& program, const LinePlacement& placement, double radius) {
    program.set("to_eye", Eigen::Matrix4f(placement.to_eye.cast<float>()));
    program.set("projection", Eigen::Matrix4f(placement.projection.cast<float>()));
    program.set("half_viewport", half_viewport());
    // A mark's corner at the far side of a line. The depth buffer has the marks and the faces
    // around them; the texture has no marks, and is enough where it is complete.
    const double to_horizon =
        placement.depths.is_complete ? 0 : kHalfDiagonal * placement.mark_pixels + radius;
    program.set("mark_reach", float(placement.diagonal *
                                    laplacian_lines::mean_scale(placement.to_eye) * to_horizon));
    glBindTexture(GL_TEXTURE_2D, placement.depths.id);
    program.set("surface_depth", 0);
    const auto [x, y, width, height] = current_viewport();
    program.set("pixels", Eigen::Vector4f(float(x) + 0.5f, float(y) + 0.5f, float(x + width) - 0.5f,
                                          float(y + height) - 0.5f));
    program.set("texel", placement.depths.texel);
}

/// For points less their set's origin.
LinePlacement relative_to(const Eigen::Vector3d& origin, LinePlacement placement) {
    const Eigen::Matrix4d shift = Eigen::Affine3d(Eigen::Translation3d(origin)).matrix();
    placement.to_eye *= shift;
    if (placement.picture_to_clip) *placement.picture_to_clip *= shift;
    return placement;
}

}  // namespace

struct LineRenderer::Objects {
    ShaderProgram program{"Lines cannot be drawn", kLineVertexShader, kLineFragmentShader,
                          kLineAttributes};
    LineBuffers buffers;
};

LineRenderer::LineRenderer() : objects_(std::make_unique<PerShareGroup<Objects>>()) {}

LineRenderer::~LineRenderer() = default;

LineRenderer::Objects LineRenderer::make_objects() {
    if (!can_draw_instanced())
        throw std::runtime_error(
            "Lines cannot be drawn: instanced drawing (OpenGL 3.3) is not available.");
    return Objects();
}

struct LineRenderer::Pass {
    GLenum depth_function = GL_LEQUAL;
    float surface_side = 1;
    double bias_factor = 1;
    bool is_dashed = false;
    bool sees_edges_exactly = true;
};

void LineRenderer::draw_pass(const Objects& objects, const LinePlacement& placement,
                             const Pass& pass, RedrawClock& clock) const {
    const ShaderProgram& program = objects.program;
    glDepthFunc(placement.depths.is_complete ? GL_ALWAYS : pass.depth_function);
    program.set("surface_side", pass.surface_side);
    set_depth_biases(program, placement, pass.bias_factor);
    program.set("to_side", float(kToSide * placement.pixel_scale));
    program.set("exact_edges", int(pass.sees_edges_exactly));
    const double dash_scale = pass.is_dashed ? placement.pixel_scale : 0;
    program.set("dash",
                Eigen::Vector2f(float(dash_scale * kDashPixels), float(dash_scale * kDashPeriod)));
    clock.count(RedrawClock::DrawCalls);
    for (const StreamPart& part : parts_) {
        if (part.length == 0) continue;
        objects.buffers.bind(part.first);
        // of four corners; a segment has a point before it and one after
        draw_instanced(GL_TRIANGLE_STRIP, 4, GLsizei(part.length) - 3);
    }
    clock.count(RedrawClock::Drawing);
}

void LineRenderer::draw_hidden(const Objects& objects, const LineAppearance& appearance,
                               const LinePlacement& placement, RedrawClock& clock) const {
    Pass hidden;
    hidden.bias_factor = kHiddenDepth;
    hidden.is_dashed = appearance.hidden == HiddenLines::Dashed;
    hidden.sees_edges_exactly = false;  // those just behind an outline would only double it
    set_colors(objects.program, appearance, hidden.is_dashed ? 1 : kFaintAlpha);
    hidden.depth_function = GL_ALWAYS;
    hidden.surface_side = -1;
    draw_pass(objects, placement, hidden, clock);
    if (placement.depths.is_complete) return;
    hidden.depth_function = GL_GREATER;  // what the depth buffer hides and the texture does not
    hidden.surface_side = 1;
    draw_pass(objects, placement, hidden, clock);
}

void LineRenderer::upload(const laplacian_lines::LineSet& lines, const LineAppearance& appearance,
                          const LinePlacement& placement) {
    std::vector<StreamPart> parts = std::move(parts_);  // to keep its memory
    parts_.clear();
    origin_ = lines.origin;
    LineBuffers& buffers = objects_->current(make_objects).buffers;
    const std::size_t most = stream_length(lines);
    if (most == 0) return;

    const StreamSettings settings =
        stream_settings(appearance, relative_to(origin_, placement), half_viewport());
    const auto write = [&](StreamPoint* stream) { write_stream(lines, settings, stream, parts); };
    if (!buffers.fill(most, std::ref(write)))  // copies are allocated
        throw std::runtime_error("Lines cannot be drawn: OpenGL has no memory for them.");
    parts_ = std::move(parts);
}

void LineRenderer::draw(const LineAppearance& appearance, const LinePlacement& placement,
                        RedrawClock& clock) {
    if (parts_.empty()) return;
    const Objects& objects = objects_->current(make_objects);
    const LineRadii in_pixels = line_radii(appearance, placement.pixel_scale);
    const GlState state;
    objects.program.use();
    set_shares_within(objects.program, appearance);
    set_placement(objects.program, relative_to(origin_, placement),
                  *std::max_element(in_pixels.begin(), in_pixels.end()));
    if (appearance.hidden != HiddenLines::LeftOut)
        draw_hidden(objects, appearance, placement, clock);
    set_colors(objects.program, appearance, 1);
    draw_pass(objects, placement, Pass(), clock);
    LineBuffers::unbind();
}

}  // namespace line_renderer
