// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace line_renderer {

template <class Object>
class PerShareGroup;

/// Whitens the part of the view that no surface covers. One program per share group. GUI thread
/// only.
class BackgroundRenderer {
public:
    BackgroundRenderer();
    ~BackgroundRenderer();

    /// Fills the pixels of the current viewport that have the depth of an empty view. Call it
    /// before any lines, which reach beyond outlines. Keeps depths and alpha, so that snapshots
    /// without background stay so, and OpenGL's state. @throws std::runtime_error if OpenGL cannot
    /// do it
    void paint();

private:
    struct Program;
    std::unique_ptr<PerShareGroup<Program>> programs_;
};

}  // namespace line_renderer
