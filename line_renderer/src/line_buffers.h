// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "gl_functions.h"
#include "line_stream.h"

namespace line_renderer {

/// What the line program reads: the corners of a quad, and the points of this frame. Needs the
/// context in which it was made, or another of its share group, to be current.
class LineBuffers {
public:
    LineBuffers();

    /// Memory for so many points, at least 1, until it is unmapped; null if there is none. Leaves
    /// the buffer bound.
    StreamPoint* map(std::size_t points);
    /// Hands the points over. False if they were lost.
    bool unmap();

    /// Makes the points from `first` on the program's attributes, one segment after the other.
    void bind(std::size_t first) const;
    /// Takes back what bind() has set and GlState does not save.
    static void unbind();

private:
    GLuint corners_ = 0;
    GLuint stream_ = 0;
    std::size_t capacity_ = 0;  ///< points that the stream has room for
};

}  // namespace line_renderer
