// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>

#include <QColor>
#include <QObject>
#include <map>
#include <string>

#include "line_renderer/share_group.h"

namespace line_renderer {

/// Colors the part of the view that no surface covers. Holds a program for each share group, which
/// lives as long as the group. GUI thread only.
class BackgroundRenderer {
public:
    /// Fills the pixels of the current viewport whose depth is that of an empty view. To be called
    /// before any lines of a redraw, which reach over outlines. Depths and alpha stay, so that
    /// snapshots without background stay so, and OpenGL's state is left as it was. Returns why
    /// nothing could be painted, empty on success.
    std::string paint(const QColor& color);

private:
    struct Program {
        GLuint id = 0;  ///< 0: not built yet, or it could not be
        GLint color = -1;
        std::string failure;
    };

    Program& programOfCurrentGroup();
    static void build(Program& program);

    std::map<ShareGroup, Program> groups_;
    QObject receiver_;  ///< of the groups' last words; destroyed first
};

}  // namespace line_renderer
