// SPDX-License-Identifier: GPL-3.0-or-later
// A segment is an instance of four corners, and its points are read from one stream of points by
// bindings that are a point apart: the one before it, its ends, the one after it.
#include "line_buffers.h"

#include <algorithm>

namespace line_renderer {
namespace {

/// From the bound buffer. `divisor` 1: one value per segment.
void point_attribute(LineAttribute attribute, GLint floats, GLsizei stride, std::size_t offset,
                     GLuint divisor) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribPointer(attribute, floats, GL_FLOAT, GL_FALSE, stride,
                          reinterpret_cast<const void*>(offset));
    set_divisor(attribute, divisor);
}

GLsizeiptr bytes(std::size_t points) {
    return GLsizeiptr(points * sizeof(StreamPoint));
}

/// Binds, at its end, the buffer that was bound before.
class KeptBinding {
public:
    KeptBinding() { glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound_); }
    ~KeptBinding() { glBindBuffer(GL_ARRAY_BUFFER, GLuint(bound_)); }
    KeptBinding(const KeptBinding&) = delete;
    KeptBinding& operator=(const KeptBinding&) = delete;

private:
    GLint bound_ = 0;
};

}  // namespace

LineBuffers::LineBuffers() {
    constexpr float corners[] = {0, -1, 1, -1, 0, 1, 1, 1};  // a triangle strip
    const KeptBinding binding;
    glGenBuffers(1, &corners_);
    glGenBuffers(1, &stream_);
    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
}

bool LineBuffers::fill(std::size_t points, const std::function<void(StreamPoint*)>& write) {
    const KeptBinding binding;
    StreamPoint* const stream = map(points);
    if (!stream) return false;
    try {
        write(stream);
    } catch (...) {
        unmap();
        throw;
    }
    return unmap();
}

/// Null if there is no memory.
StreamPoint* LineBuffers::map(std::size_t points) {
    const bool has_ranges = gl_features().buffer_ranges;
    glBindBuffer(GL_ARRAY_BUFFER, stream_);
    if (points > capacity_ || !has_ranges) {  // without ranges this discards what it holds
        capacity_ = std::max(capacity_, points + points / 4);
        glBufferData(GL_ARRAY_BUFFER, bytes(capacity_), nullptr, GL_STREAM_DRAW);
    }
    // Discarded either way, so the driver need not wait for the last frame.
    void* memory = has_ranges ? glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes(points),
                                                 GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT)
                              : glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
    if (!memory) capacity_ = 0;
    return static_cast<StreamPoint*>(memory);
}

/// False if the points were lost.
bool LineBuffers::unmap() {
    const bool is_kept = glUnmapBuffer(GL_ARRAY_BUFFER);
    if (!is_kept) capacity_ = 0;
    return is_kept;
}

void LineBuffers::bind(std::size_t first) const {
    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    point_attribute(Corner, 2, 0, 0, 0);

    glBindBuffer(GL_ARRAY_BUFFER, stream_);
    const std::size_t begin = first * sizeof(StreamPoint);
    std::size_t offset = begin;
    for (LineAttribute attribute : {Before, Start, End, After}) {
        point_attribute(attribute, 4, sizeof(StreamPoint), offset, 1);
        offset += sizeof(StreamPoint);
    }
    constexpr std::size_t kLook = offsetof(StreamPoint, opacity);
    static_assert(kLook == 4 * sizeof(float) && sizeof(StreamPoint) >= kLook + 3 * sizeof(float));
    const std::size_t look = begin + kLook;
    point_attribute(StartLook, 3, sizeof(StreamPoint), sizeof(StreamPoint) + look, 1);
    point_attribute(EndLook, 3, sizeof(StreamPoint), 2 * sizeof(StreamPoint) + look, 1);
}

void LineBuffers::unbind() {
    for (LineAttribute attribute : {Before, Start, End, After, StartLook, EndLook})
        set_divisor(attribute, 0);
}

}  // namespace line_renderer
