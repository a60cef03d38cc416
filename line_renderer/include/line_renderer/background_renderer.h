// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <memory>

namespace line_renderer {

template <class Object>
class PerShareGroup;

/// Colors the part of the view that no surface covers. Holds a program for each share group, which
/// lives as long as the group. GUI thread only.
class BackgroundRenderer {
public:
    BackgroundRenderer();
    ~BackgroundRenderer();

    /// Fills the pixels of the current viewport whose depth is that of an empty view. To be called
    /// before any lines of a redraw, which reach over outlines. Depths and alpha stay, so that
    /// snapshots without background stay so, and OpenGL's state is left as it was.
    /// @throws std::runtime_error if OpenGL cannot do it
    void paint(const QColor& color);

private:
    struct Program;
    std::unique_ptr<PerShareGroup<Program>> programs_;
};

}  // namespace line_renderer
