// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "gl_functions.h"
#include "line_stream.h"

namespace line_renderer {

/// Of the line program. Corner is 0, which some drivers want to advance with every vertex; the
/// others advance with every segment.
enum LineAttribute : GLuint { Corner, Before, Start, End, After, StartLook, EndLook };
inline const std::vector<const char*> kLineAttributes = {"corner", "before",     "start",   "end",
                                                         "after",  "start_look", "end_look"};

/// Input of the line program: corners of a quad, and this frame's points. Needs a current context
/// of its share group.
class LineBuffers {
public:
    LineBuffers();

    /// Has `write` fill memory for so many points, at least 1. False if there is none, or if OpenGL
    /// has lost them.
    bool fill(std::size_t points, const std::function<void(StreamPoint*)>& write);

    /// Feeds the points from `first` on to the program, segment by segment.
    void bind(std::size_t first) const;
    /// Undoes what GlState does not.
    static void unbind();

private:
    StreamPoint* map(std::size_t points);
    bool unmap();

    GLuint corners_ = 0;
    GLuint stream_ = 0;
    std::size_t capacity_ = 0;  ///< points that the stream has room for
};

}  // namespace line_renderer
