// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl_functions.h"

namespace line_renderer {

/// Draws the segments of a StreamPoint array. Needs OpenGL 2.0; belongs to the current share group.
struct LineProgram {
    /// Attribute locations. Corner is 0, which some drivers want to advance with every vertex; the
    /// others advance with every segment.
    enum Attribute : GLuint {
        Corner = 0,
        Before = 1,
        Start = 2,
        End = 3,
        After = 4,
        StartLook = 5,
        EndLook = 6
    };

    /// @throws std::runtime_error if it cannot be built
    LineProgram();

    GLuint id;
    GLint to_eye;         ///< mat4, mesh to eye coordinates
    GLint projection;     ///< mat4
    GLint half_viewport;  ///< vec2, pixels
    GLint depth_biases;   ///< float[most_looks], lengths in eye coordinates, see line_shaders.cpp
    GLint mark_reach;     ///< float, length in eye coordinates times pixels, or 0; see there
    GLint surface_depth;  ///< sampler2D
    GLint texel;          ///< vec2, of surface_depth for a pixel
    GLint pixels;         ///< vec4, middles of the viewport's first and last pixel
    GLint to_side;        ///< float, pixels
    GLint edge_reach;     ///< vec2, pixels, see line_shaders.cpp
    GLint surface_side;   ///< float: 1 before the surface, -1 behind it
    GLint colors;         ///< vec4[most_looks]
    GLint dash;           ///< vec2, pixels: length of a dash and of a dash with its gap; or 0
};

}  // namespace line_renderer
