// SPDX-License-Identifier: GPL-3.0-or-later
#include "shaders.h"

namespace line_renderer {

const char* const surface_vertex_shader = R"(#version 120
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

// Depth: MeshLab's wires and points are flat on the screen, so on a slope they stand out by what it
// falls in half their width, and at a fold over the part behind. Only the compared depth is moved;
// none is written.
const char* const surface_fragment_shader = R"(#version 120
uniform bool is_toon;
uniform vec2 nearer;  // least and greatest move towards the eye, length in eye coordinates
uniform sampler2D surface_depth;  // of the nearest faces
uniform vec2 texel;  // of it, for a pixel; zero: the depth buffer alone decides
varying vec3 eye_position;
varying vec3 eye_normal;

const float pixels_of_slope = 3.0;
const float tones = 3.0;
const float shade = 150.0 / 255.0;

vec3 towardsEye()
{
    bool orthographic = gl_ProjectionMatrix[2][3] == 0.0;
    return orthographic ? vec3(0.0, 0.0, 1.0) : normalize(-eye_position);
}

float depthMoved(float distance)
{
    vec4 clip = gl_ProjectionMatrix * vec4(eye_position + distance * towardsEye(), 1.0);
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
    float brightness = size > 0.0 ? abs(dot(eye_normal, towardsEye())) / size : 1.0;
    float scaled = brightness * tones;
    float step_at = floor(scaled + 0.5);
    float width = max(fwidth(scaled), 1e-6);
    float level = step_at - 1.0 + clamp((scaled - step_at) / width + 0.5, 0.0, 1.0);
    return clamp(level / (tones - 1.0), 0.0, 1.0);
}

bool isHidden(float slope)
{
    float nearest = texture2D(surface_depth, gl_FragCoord.xy * texel).r;
    return texel.x > 0.0 && gl_FragCoord.z > nearest + 0.5 * slope + 1e-6;
}

// Within half the width of points and wires.
float nearestAround()
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
    if (isHidden(slope))
        discard;
    float moved = clamp(gl_FragCoord.z - pixels_of_slope * slope,
                        depthMoved(nearer.y), depthMoved(nearer.x));
    gl_FragDepth = min(moved, nearestAround() + depthMoved(nearer.y) - gl_FragCoord.z);
    gl_FragColor = vec4(vec3(mix(shade, 1.0, tone())), 1.0);
}
)";

}  // namespace line_renderer
