// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace line_renderer {

/// GLSL 1.20. Paints faces in flat tones by the angle between the normal and the ray of sight, and
/// a little nearer to the eye than they are.
extern const char* const surface_vertex_shader;
extern const char* const surface_fragment_shader;

}  // namespace line_renderer
