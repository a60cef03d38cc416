// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace line_renderer {

/// GLSL 1.20. The vertex shader widens a segment to a quad in pixels, the fragment shader cuts the
/// quad to the segment's share of the line.
extern const char* const line_vertex_shader;
extern const char* const line_fragment_shader;

}  // namespace line_renderer
