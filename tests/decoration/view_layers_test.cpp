// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_layers.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <new>

#include "event_loop.h"

namespace {

using line_renderer::Surface;
using line_renderer::SurfaceLayer;

class ViewLayersTest : public testing::Test {
protected:
    /// The surface, moved by `shift` along x; `is_in_depth_buffer`: MeshLab's depth buffer has it.
    SurfaceLayer layer(double shift, bool is_in_depth_buffer = false) const {
        SurfaceLayer result;
        result.surface = surface_;
        result.transform(0, 3) = shift;
        result.is_in_depth_buffer = is_in_depth_buffer;
        return result;
    }

    /// One redraw, which reaches these layers as meshes 0, 1, ...
    void redraw(const std::vector<SurfaceLayer>& layers) {
        for (std::size_t i = 0; i < layers.size(); ++i)
            layers_.reach(view_, &widget_, int(i), layers[i], i == 0, is_painted_);
    }

    int redraws_after(const std::vector<SurfaceLayer>& layers) {
        const int before = widget_.redraws();
        redraw(layers);
        wait(100);
        return widget_.redraws() - before;
    }

    CountingWidget widget_;
    ViewLayers layers_;
    bool is_painted_ = false;  // as reach() takes it
    const int name_ = 0;
    const ViewLayers::View view_ = &name_;
    const std::shared_ptr<const Surface> surface_ = std::make_shared<Surface>();
};

TEST_F(ViewLayersTest, OfOneViewAreNotThoseOfAnother) {
    const int other = 0;
    redraw({layer(1), layer(2)});
    EXPECT_TRUE(layers_.in(&other).empty());
    EXPECT_FALSE(layers_.reach(&other, nullptr, 0, layer(1), true, false));
    layers_.forget(view_);
    EXPECT_TRUE(layers_.in(view_).empty());
    EXPECT_EQ(layers_.in(&other).size(), 1u);
}

TEST_F(ViewLayersTest, AreInTheDepthBufferOnlyTogether) {
    EXPECT_FALSE(layers_.are_in_depth_buffer(view_)) << "nothing is known";
    redraw({layer(1, true), layer(2, true)});
    EXPECT_TRUE(layers_.are_in_depth_buffer(view_));
    redraw({layer(1, true), layer(2, false)});
    EXPECT_FALSE(layers_.are_in_depth_buffer(view_));
}

/// Drawn as if a layer were still in its former place.
TEST_F(ViewLayersTest, RedrawAViewThatWasWrong) {
    EXPECT_EQ(redraws_after({layer(1), layer(2)}), 1) << "the second one is new";
    EXPECT_EQ(redraws_after({layer(1), layer(2)}), 0);
    EXPECT_EQ(redraws_after({layer(1), layer(3)}), 1) << "the second one has moved";
    EXPECT_EQ(redraws_after({layer(1)}), 1) << "the second one is gone";
    EXPECT_EQ(redraws_after({layer(1)}), 0);
    EXPECT_EQ(redraws_after({layer(4)}), 0) << "the first one is known before any line is drawn";
}

/// There it does not matter that a layer is not as it was.
TEST_F(ViewLayersTest, DoNotRedrawWhatTheDepthBufferHides) {
    EXPECT_EQ(redraws_after({layer(1, true), layer(2, true)}), 0);
    EXPECT_EQ(redraws_after({layer(1, true), layer(3, true)}), 0);
    EXPECT_EQ(redraws_after({layer(1, true)}), 0);
    is_painted_ = true;
    EXPECT_EQ(redraws_after({layer(1, true), layer(2, true)}), 1) << "painted over lines";
    EXPECT_EQ(redraws_after({layer(1, true), layer(2, true)}), 0);
}

TEST_F(ViewLayersTest, MayOutliveTheWidget) {
    alignas(QWidget) unsigned char memory[sizeof(QWidget)];
    auto* const widget = new (memory) QWidget;
    layers_.reach(view_, widget, 0, layer(1), true, false);
    layers_.reach(view_, widget, 1, layer(2), false, false);
    widget->~QWidget();
    std::memset(memory, 0xff, sizeof memory);  // who still uses it crashes
    wait(50);
    EXPECT_EQ(layers_.in(view_).size(), 2u);
}

}  // namespace
