// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>

#include <string>

namespace line_renderer {

/// The shader program that draws the segments of a StreamPoint array.
struct LineProgram {
    /// Attribute locations. Corner comes first because some drivers want the attribute at location
    /// 0 to advance with every vertex; the others advance with every segment.
    enum Attribute : GLuint {
        Corner = 0,
        Before = 1,
        Start = 2,
        End = 3,
        After = 4,
        StartLook = 5,
        EndLook = 6
    };

    GLuint id = 0;             ///< 0: could not be built
    GLint to_eye = -1;         ///< mat4, mesh to eye coordinates
    GLint projection = -1;     ///< mat4
    GLint half_viewport = -1;  ///< vec2, pixels
    GLint depth_bias = -1;     ///< vec2, lengths in eye coordinates, see line_shaders.cpp
    GLint mark_reach = -1;     ///< float, length in eye coordinates times pixels, or 0; see there
    GLint surface_depth = -1;  ///< sampler2D
    GLint texel = -1;          ///< vec2, of surface_depth for a pixel
    GLint pixels = -1;         ///< vec4, middles of the viewport's first and last pixel
    GLint to_side = -1;        ///< float, pixels
    GLint surface_side = -1;   ///< float: 1 before the surface, -1 behind it
    GLint color = -1;          ///< vec4
    GLint contour_color = -1;  ///< vec4
    GLint dash = -1;           ///< vec2, pixels: length of a dash and of a dash with its gap; or 0
    std::string failure;       ///< the compiler's words if id is 0
};

/// Needs a current context with OpenGL 2.0; the program belongs to its share group.
LineProgram buildLineProgram();

}  // namespace line_renderer
