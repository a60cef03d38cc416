// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/surface_renderer.h"

#include <algorithm>

#include "gl_state.h"
#include "laplacian_lines/view.h"
#include "per_share_group.h"
#include "shader_program.h"

namespace line_renderer {
namespace {

/// Depth bias of paint, to cover wires and points, in diagonals. If these have 1000 pixels on the
/// screen, the least is half a pixel, for faces without a slope; the greatest is how far marks
/// stand out of a ball, sqrt(2 R d) of line_shaders.cpp, at d = .9 pixels from its horizon.
constexpr double kLeastMove = 0.0005;
constexpr double kGreatestMove = 0.03;

// Paints faces, slightly nearer to the eye, in flat tones by the angle between normal and ray.
const char* const kSurfaceVertexShader = R"(#version 120
varying vec3 eye_position;
varying vec3 eye_normal;

void main()
{
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    eye_position = eye.xyz / eye.w;
    eye_normal = gl_NormalMatrix * gl_Normal;
    gl_Position = ftransform();
}
)";

// Depth: MeshLab's wires and points are flat on the screen, so on a slope they stand out by its
// fall over half their width, and at a fold cover the part behind. Only the compared depth is
// biased; none is written. Depths are the window's, 0..1; a slope is their change per pixel,
// along x plus along y: as from a mark's middle to a corner, for each pixel of half its width.
const char* const kSurfaceFragmentShader = R"(#version 120
uniform bool is_toon;
uniform vec2 nearer;  // least and greatest move towards the eye, length in eye coordinates
uniform sampler2D surface_depth;  // of the nearest faces
uniform vec2 texel;  // of it, for a pixel; zero: the depth buffer alone decides
varying vec3 eye_position;
varying vec3 eye_normal;

// Half of marks of 6: MeshLab's points of 3 pixels, up to doubled by attenuation.
const float pixels_of_slope = 3.0;
const float tones = 3.0;
const float shade = 150.0 / 255.0;  // gray of the darkest tone

vec3 towards_eye()
{
    bool orthographic = gl_ProjectionMatrix[2][3] == 0.0;
    return orthographic ? vec3(0.0, 0.0, 1.0) : normalize(-eye_position);
}

float moved_depth(float distance)
{
    vec4 clip = gl_ProjectionMatrix * vec4(eye_position + distance * towards_eye(), 1.0);
    if (clip.w <= 0.0)
        return 0.0;
    return (gl_DepthRange.diff * clip.z / clip.w + gl_DepthRange.near + gl_DepthRange.far) * 0.5;
}

// 0 in the shade, 1 on bare paper, with steps one pixel wide.
float tone()
{
    if (!is_toon)
        return 1.0;
    float size = length(eye_normal);
    float brightness = size > 0.0 ? abs(dot(eye_normal, towards_eye())) / size : 1.0;
    float scaled = brightness * tones;
    float step_at = floor(scaled + 0.5);
    float width = max(fwidth(scaled), 1e-6);
    float level = step_at - 1.0 + clamp((scaled - step_at) / width + 0.5, 0.0, 1.0);
    return clamp(level / (tones - 1.0), 0.0, 1.0);
}

// By more than half a pixel's fall and rounding: 1e-6 are 17 steps of the texture's 24 bits.
bool is_hidden(float slope)
{
    float nearest = texture2D(surface_depth, gl_FragCoord.xy * texel).r;
    return texel.x > 0.0 && gl_FragCoord.z > nearest + 0.5 * slope + 1e-6;
}

// Least depth within half the width of marks of up to 5 pixels.
float nearest_around()
{
    float nearest = 1.0;
    if (texel.x > 0.0)
        for (float y = -2.0; y <= 2.0; y += 1.0)
            for (float x = -2.0; x <= 2.0; x += 1.0) {
                vec2 place = (gl_FragCoord.xy + vec2(x, y)) * texel;
                nearest = min(nearest, texture2D(surface_depth, place).r);
            }
    return nearest;
}

void main()
{
    float slope = fwidth(gl_FragCoord.z);
    if (is_hidden(slope))
        discard;
    float moved = clamp(gl_FragCoord.z - pixels_of_slope * slope,
                        moved_depth(nearer.y), moved_depth(nearer.x));
    gl_FragDepth = min(moved, nearest_around() + moved_depth(nearer.y) - gl_FragCoord.z);
    gl_FragColor = vec4(vec3(mix(shade, 1.0, tone())), 1.0);
}
)";

// At the depth of an empty view.
const char* const kBackgroundVertexShader = R"(#version 120
void main()
{
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
}
)";

const char* const kBackgroundFragmentShader = R"(#version 120
void main()
{
    gl_FragColor = vec4(1.0);
}
)";

}  // namespace

SurfaceRenderer::SurfaceRenderer()
    : surface_programs_(std::make_unique<PerShareGroup<ShaderProgram>>()),
      background_programs_(std::make_unique<PerShareGroup<ShaderProgram>>()) {}

SurfaceRenderer::~SurfaceRenderer() = default;

void SurfaceRenderer::paint(const SurfaceLayer& layer, SurfaceStyle style,
                            const Eigen::Matrix4d& to_eye, const DepthTexture& depth,
                            SurfaceBuffers& buffers) {
    const ShaderProgram& program = surface_programs_->current([] {
        return ShaderProgram("The surface cannot be painted", kSurfaceVertexShader,
                             kSurfaceFragmentShader);
    });
    const GlState state;
    glDisable(GL_BLEND);
    program.use();
    program.set("is_toon", style == SurfaceStyle::Toon);
    const SurfacePointer surface = layer.surface.lock();
    const double least = std::max(kLeastMove * layer.diagonal, surface ? surface->most_behind : 0.);
    const double greatest = std::max(kGreatestMove * layer.diagonal, least);  // clamp() needs it
    const double scale = laplacian_lines::mean_scale(to_eye);
    program.set("nearer", Eigen::Vector2f(float(least * scale), float(greatest * scale)));
    const bool is_needed = !depth.is_complete;
    glBindTexture(GL_TEXTURE_2D, is_needed ? depth.id : 0);
    program.set("surface_depth", 0);
    program.set("texel", is_needed ? depth.texel : Eigen::Vector2f(0, 0));
    buffers.draw(layer);
}

void SurfaceRenderer::paint_background() {
    const ShaderProgram& program = background_programs_->current([] {
        return ShaderProgram("The background cannot be painted", kBackgroundVertexShader,
                             kBackgroundFragmentShader);
    });
    const GlState state;
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    program.use();
    glRectf(-1, -1, 1, 1);
}

}  // namespace line_renderer
