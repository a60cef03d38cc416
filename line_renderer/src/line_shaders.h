// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace line_renderer {

/// GLSL 1.20. Widens a segment to a quad in pixels, of which the fragment shader keeps the
/// segment's share of the line.
extern const char* const kLineVertexShader;
extern const char* const kLineFragmentShader;

/// Size of the shaders' arrays of looks.
constexpr std::size_t kMostLooks = 16;

}  // namespace line_renderer
