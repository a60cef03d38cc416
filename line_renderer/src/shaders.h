// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace line_renderer {

/// GLSL 1.20. The vertex shader widens a segment to a quad in pixels, the fragment shader cuts the
/// quad to the segment's share of the line.
extern const char* const line_vertex_shader;
extern const char* const line_fragment_shader;

/// How many looks the shaders hold.
constexpr std::size_t most_looks = 16;

/// GLSL 1.20. Paints faces in flat tones by the angle between the normal and the ray of sight, and
/// a little nearer to the eye than they are.
extern const char* const surface_vertex_shader;
extern const char* const surface_fragment_shader;

}  // namespace line_renderer
