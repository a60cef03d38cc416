// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
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

    /// Room for so many points, at least 1, until unmapped; null if there is no memory. The buffer
    /// stays bound.
    StreamPoint* map(std::size_t points);
    /// False if the points were lost.
    bool unmap();

    /// Feeds the points from `first` on to the program, segment by segment.
    void bind(std::size_t first) const;
    /// Undoes what GlState does not.
    static void unbind();

private:
    GLuint corners_ = 0;
    GLuint stream_ = 0;
    std::size_t capacity_ = 0;  ///< points that the stream has room for
};

}  // namespace line_renderer
