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

}  // namespace line_renderer
