// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "canvas.h"
#include "gl_context.h"

/// A test with an OpenGL context of its own that draws on a canvas.
class GlTest : public testing::Test {
protected:
    GlContext context_;
    Canvas canvas_;
};
