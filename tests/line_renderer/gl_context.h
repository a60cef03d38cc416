// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <memory>

#include "canvas.h"

/// An OpenGL context without a window, on the display, current until another one is.
class GlContext {
public:
    /// In a share group of its own, or in that of `partner`.
    /// @throws std::runtime_error if there is no OpenGL
    explicit GlContext(const GlContext* partner = nullptr);
    ~GlContext();

    void makeCurrent();

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

/// A test with an OpenGL context of its own that draws on a canvas.
class GlTest : public testing::Test {
protected:
    GlContext context_;
    Canvas canvas_;
};
