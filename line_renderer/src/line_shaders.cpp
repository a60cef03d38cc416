// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_shaders.h"

namespace line_renderer {

// How a line is drawn, segment by segment. The vertex shader gets four successive points of a line
// and draws the segment between the middle two:
//  1. Both ends in eye coordinates, cut at the near plane, and on the screen.
//  2. Joints: the segment and its neighbours are cut where they meet, along the bisector, so that
//     every pixel is painted once; overlapping soft edges would add up to hard ones. Where a line
//     turns by more than a right angle, both have round ends instead: the cut would be longer than
//     the line is wide, and half of the cusp would be missing where the neighbour is shorter or
//     hidden.
//  3. A rectangle around the segment, as wide as the line and a little longer.
//  4. Depths of the line, moved towards the eye by the depth bias.
// For every pixel of the rectangle the fragment shader takes
//  5. the share that the segment covers, between its cuts and in its dashes, and
//  6. whether it is seen: whether the point in the middle of the line is in front of the surface
//     there or a little to either side. So a line is drawn in full width or not at all, even along
//     an outline, where the surface would hide its inner half. Where a contour follows a mesh edge,
//     its surface ends there on the screen: the bias is only a few pixels, for surfaces that it
//     stands on, and to the side depths are compared up to a pixel whose centre is beyond. So a
//     fold just behind the edge stays hidden.
//
// Where MeshLab draws points or wires, depths are those of surfaces alone: such marks are flat on
// the screen and stand out of a surface that falls away, by sqrt(2 R d) at d pixels from the
// horizon of a ball of radius R. The depth buffer is compared as well, with a bias as long as that,
// so that only objects well in front hide lines.
const char* const kLineVertexShader = R"(#version 120
attribute vec2 corner;  // x: 0 at the start, 1 at the end; y: -1 or 1, side
attribute vec4 before;  // as a StreamPoint: position, radius in pixels or a negative mark
attribute vec4 start;
attribute vec4 end;
attribute vec4 after;
attribute vec3 start_look;  // opacity, number of the look, pixels from the start of the line
attribute vec3 end_look;
uniform mat4 to_eye;
uniform mat4 projection;
uniform vec2 half_viewport;
uniform vec4 colors[16];        // of the looks
uniform float depth_biases[16];
uniform float shares_within[16];  // of the radius, where there is a surface on both sides
uniform sampler2D surface_depth;
uniform vec2 texel;   // of surface_depth for a pixel
uniform vec4 pixels;  // middles of the viewport's first and last pixel
uniform float to_side;    // pixels
uniform bool exact_edges;  // lines that are seen: what follows edges of the mesh is exact
uniform float mark_reach;  // diameter of the largest ball times pixels to its horizon
varying vec2 place;  // pixels along and across, from the start of the segment
varying vec4 shape;  // length, radius at the start, at the end, to the sides of depths; pixels
varying vec4 cuts;   // normals of the cuts at the start and at the end; zero: a round end
varying vec2 starts;  // at the start of the segment: opacity, pixels from the start of the line
varying vec2 ends;
varying vec4 ink;
varying vec4 middle;  // direction on the screen, depths in 0..1 at the start and at the end

// Marks of line_stream.h: kNeighbourOnly, of points with a position, is below, kNothingHere above.
const float between_marks = -1.5;
const float edge_mark = 0.25;
const float away_mark = 0.4;
// Of what follows edges, pixels: to the side as far as a pixel's centre may be beyond the edge; and
// the greatest move to the eye, the rise over 1.5 pixels of a surface that leans by 70 degrees,
// such as the ground.
const float edge_side = 0.7072;
const float edge_move = 4.0;

vec4 in_eye(vec4 point)
{
    vec4 eye = to_eye * vec4(point.xyz, 1.0);
    return eye / eye.w;
}

// How far a point is before the near plane, in clip coordinates; negative behind it.
float before_near_plane(vec4 eye)
{
    vec4 clip = projection * eye;
    return clip.z + clip.w;
}

vec2 on_screen(vec4 eye)
{
    vec4 clip = projection * eye;
    return clip.xy / clip.w * half_viewport;
}

// Size of a pixel there, in eye coordinates.
float pixel_at(vec4 eye)
{
    return (projection * eye).w / (projection[1][1] * half_viewport.y);
}

// How far marks stand out of the surface at most, eye coordinates.
float mark_height(vec4 eye)
{
    return sqrt(max(mark_reach * pixel_at(eye), 0.0));
}

// Depth, in -1..1, of a point that is moved towards the viewer in eye coordinates.
float moved_depth(vec4 eye, float bias)
{
    bool orthographic = projection[2][3] == 0.0;
    vec3 towards_viewer = orthographic ? vec3(0.0, 0.0, 1.0) : normalize(-eye.xyz);
    vec4 clip = projection * vec4(eye.xyz + bias * towards_viewer, 1.0);
    return clip.w > 0.0 ? max(clip.z / clip.w, -1.0) : -1.0;
}

// Depth of the surface beside a line, `across` from its middle.
float depth_beside(vec2 screen, vec2 across)
{
    vec2 pixel = screen + across + half_viewport + pixels.xy - 0.5;
    return texture2DLod(surface_depth, clamp(pixel, pixels.xy, pixels.zw) * texel, 0.0).r;
}

// The line's radius: the share within, unless it is an outline, with background 3 pixels beside it;
// narrower gaps between surfaces do not count.
float radius_at(vec2 screen, vec2 across, float radius, float share_within)
{
    if (share_within == 1.0)
        return radius;
    vec2 beside = (radius + 3.0) * across;
    bool is_outline = max(depth_beside(screen, beside), depth_beside(screen, -beside)) == 1.0;
    return is_outline ? radius : share_within * radius;
}

// Normal of the cut at an end of the segment, along and across it; zero: a round end. The neighbour
// there, if there is one, ends at `other` and goes by `onwards` on the screen.
vec2 cut_at(vec4 neighbour, vec4 other, float end_before, vec2 direction, vec2 onwards)
{
    bool is_there = neighbour.w >= 0.0 || neighbour.w < between_marks;
    if (!is_there || end_before <= 0.0 || before_near_plane(other) <= 0.0)
        return vec2(0.0);
    float size = length(onwards);
    if (size <= 1e-4 || dot(direction, onwards) < 0.0)
        return vec2(0.0);
    vec2 normal = direction + onwards / size;
    return vec2(dot(normal, direction), dot(normal, vec2(-direction.y, direction.x)));
}

// In 0..1, of a point of the line.
float line_depth(vec4 eye, float bias, bool is_edge)
{
    float move = is_edge && exact_edges ? min(bias, edge_move * pixel_at(eye)) : bias;
    return 0.5 * moved_depth(eye, move) + 0.5;
}

void main()
{
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside: nothing is drawn, unless it is set below
    place = vec2(0.0);
    shape = vec4(0.0);
    cuts = vec4(0.0);
    starts = start_look.xz;
    ends = end_look.xz;
    int look = int(start_look.y + 0.5);
    float mark = start_look.y - float(look);
    bool is_edge = mark > 0.5 * edge_mark;
    bool faces_away = mark > 0.5 * (edge_mark + away_mark);
    ink = colors[look];
    middle = vec4(0.0);
    if (start.w < 0.0 || end.w < 0.0)
        return;
    if (faces_away && exact_edges)
        return;

    // 1. eye and screen
    vec4 a = in_eye(start);
    vec4 b = in_eye(end);
    float a_front = before_near_plane(a);
    float b_front = before_near_plane(b);
    if (a_front <= 0.0 && b_front <= 0.0)
        return;
    vec4 visible_a = a_front < 0.0 ? mix(a, b, a_front / (a_front - b_front)) : a;
    vec4 visible_b = b_front < 0.0 ? mix(b, a, b_front / (b_front - a_front)) : b;
    vec2 screen_a = on_screen(visible_a);
    vec2 screen_b = on_screen(visible_b);
    vec2 direction = screen_b - screen_a;
    float extent = length(direction);
    direction = extent > 1e-4 ? direction / extent : vec2(1.0, 0.0);
    vec2 across = vec2(-direction.y, direction.x);

    // 2. joints
    vec4 p = in_eye(before);
    vec4 n = in_eye(after);
    cuts = vec4(cut_at(before, p, a_front, direction, screen_a - on_screen(p)),
                cut_at(after, n, b_front, direction, on_screen(n) - screen_b));

    // 3. rectangle
    vec2 radii = vec2(radius_at(screen_a, across, start.w, shares_within[look]),
                      radius_at(screen_b, across, end.w, shares_within[look]));
    float reach = max(radii.x, radii.y) + 0.55;  // half a pixel beyond it, coverage is 0
    place = vec2(corner.x * extent + (2.0 * corner.x - 1.0) * reach, corner.y * reach);
    shape = vec4(extent, radii, is_edge && exact_edges ? edge_side : to_side);
    vec2 screen = screen_a + direction * place.x + across * place.y;

    // 4. depths; w = 1 keeps the interpolation linear on the screen
    float bias = depth_biases[look];
    middle = vec4(direction, line_depth(visible_a, bias, is_edge),
                  line_depth(visible_b, bias, is_edge));
    vec4 visible = corner.x < 0.5 ? visible_a : visible_b;
    gl_Position = vec4(screen / half_viewport,
                       moved_depth(visible, max(bias, mark_height(visible))), 1.0);
}
)";

const char* const kLineFragmentShader = R"(#version 120
uniform vec2 dash;  // lengths of a dash and of a dash with its gap; zero: no gaps
varying vec2 place;
varying vec4 shape;
varying vec4 cuts;
varying vec2 starts;
varying vec2 ends;
varying vec4 ink;
varying vec4 middle;
uniform sampler2D surface_depth;
uniform vec2 texel;          // of surface_depth for a pixel
uniform vec4 pixels;         // middles of the viewport's first and last pixel
uniform float surface_side;  // 1: lines before the surface, -1: those behind it

float depth_at(vec2 pixel)
{
    return texture2D(surface_depth, clamp(pixel, pixels.xy, pixels.zw) * texel).r;
}

// Whether the line is on the unwanted side, `along` pixels from the segment's start.
bool is_on_other_side(float along, float part)
{
    vec2 across = vec2(-middle.y, middle.x);
    vec2 here = gl_FragCoord.xy - (place.x - along) * middle.xy - place.y * across;
    vec2 beside = shape.w * across;
    float farthest = max(depth_at(here), max(depth_at(here + beside), depth_at(here - beside)));
    return surface_side * (farthest - mix(middle.z, middle.w, part)) < 0.0;
}

// How much of a pixel a dash covers.
float dash_coverage(float pixels)
{
    if (dash.y <= 0.0)
        return 1.0;
    float from_middle = abs(mod(pixels, dash.y) - 0.5 * dash.x);
    from_middle = min(from_middle, dash.y - from_middle);
    return clamp(0.5 * dash.x - from_middle + 0.5, 0.0, 1.0);
}

void main()
{
    vec2 from_end = vec2(place.x - shape.x, place.y);
    if (dot(place, cuts.xy) < 0.0 || dot(from_end, cuts.zw) > 0.0)
        discard;
    float along = clamp(place.x, 0.0, shape.x);
    float part = shape.x > 0.0 ? along / shape.x : 0.0;
    float radius = mix(shape.y, shape.z, part);
    vec2 look = mix(starts, ends, part);
    float distance_to_segment = length(place - vec2(along, 0.0));
    // 5. coverage; lines thinner than a pixel fade instead of breaking up
    float coverage = clamp(radius + 0.5 - distance_to_segment, 0.0, 1.0) * min(1.0, 2.0 * radius);
    coverage *= look.x * dash_coverage(look.y);
    // 6. visibility
    if (coverage <= 0.0 || is_on_other_side(along, part))
        discard;
    gl_FragColor = vec4(ink.rgb, ink.a * coverage);
}
)";

}  // namespace line_renderer
