// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <memory>

#include "canvas.h"

/// Without a window; current until another one is.
class GlContext {
public:
    /// In its own share group, or `partner`'s. @throws std::runtime_error if there is no OpenGL
    explicit GlContext(const GlContext* partner = nullptr);
    ~GlContext();

    void makeCurrent();

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

/// Draws on a canvas in its own context.
class GlTest : public testing::Test {
protected:
    GlContext context_;
    Canvas canvas_;
};
