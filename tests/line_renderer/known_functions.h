// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Has GLEW find the functions of the current context, which are those of all of them here. Apart
/// from gl_context.cpp because Qt's OpenGL headers do not get along with GLEW's.
bool findFunctions();
