// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace line_renderer {

/// GLSL 1.20. Widens a segment to a quad in pixels, of which the fragment shader keeps the
/// segment's share of the line.
extern const char* const line_vertex_shader;
extern const char* const line_fragment_shader;

/// Looks that the shaders hold.
constexpr std::size_t most_looks = 16;

/// GLSL 1.20. Paints faces, slightly nearer to the eye, in flat tones by the angle between normal
/// and ray.
extern const char* const surface_vertex_shader;
extern const char* const surface_fragment_shader;

}  // namespace line_renderer
