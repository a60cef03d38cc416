// SPDX-License-Identifier: GPL-3.0-or-later
// Geometry is checked at once after anything that may have changed it, now and then while the
// camera moves.
#include "geometry_check.h"

#include <gtest/gtest.h>

#include <QWidget>
#include <cstddef>
#include <cstring>

#include "event_loop.h"

namespace {

class GeometryCheckTest : public testing::Test {
protected:
    /// Of a redraw after a camera move.
    bool is_due_after_move(unsigned presses = 0) {
        modelview_(0, 3) += 1;
        return check_.is_due(modelview_, presses, &widget_);
    }
    bool is_due_without_move(unsigned presses = 0) {
        return check_.is_due(modelview_, presses, &widget_);
    }

    CountingWidget widget_;
    GeometryCheck check_;
    Eigen::Matrix4d modelview_ = Eigen::Matrix4d::Identity();
};

TEST_F(GeometryCheckTest, IsDueUnlessTheCameraAloneHasMoved) {
    EXPECT_TRUE(is_due_without_move()) << "the first redraw";
    EXPECT_FALSE(is_due_after_move());
    EXPECT_TRUE(is_due_without_move());
    EXPECT_FALSE(is_due_after_move());
    EXPECT_TRUE(is_due_after_move(1)) << "a key or button was pressed";
    EXPECT_FALSE(is_due_after_move(1));
}

/// A quarter of a second after the last check.
TEST_F(GeometryCheckTest, IsDueNowAndThenWhileTheCameraMoves) {
    is_due_without_move();
    QElapsedTimer clock;
    clock.start();
    while (!is_due_after_move() && clock.elapsed() < 5000)
        wait(10);
    EXPECT_GE(clock.elapsed(), 240);
    EXPECT_LT(clock.elapsed(), 5000);
}

TEST_F(GeometryCheckTest, RedrawsOnceMoreWhenTheCameraHasStopped) {
    is_due_without_move();
    ASSERT_FALSE(is_due_after_move());
    wait(1000);
    EXPECT_EQ(widget_.redraws(), 1);
}

/// The widget's memory is overwritten: redrawing it would crash.
TEST_F(GeometryCheckTest, MayOutliveTheWidget) {
    alignas(QWidget) std::byte place[sizeof(QWidget)];
    auto* const widget = new (place) QWidget;
    GeometryCheck check;
    check.is_due(modelview_, 0, widget);
    modelview_(0, 3) += 1;
    ASSERT_FALSE(check.is_due(modelview_, 0, widget));
    widget->~QWidget();
    std::memset(place, 0xff, sizeof place);
    wait(400);
}

TEST(PressCount, CountsKeysAndButtonsAnywhere) {
    const PressCount count;
    QObject receiver;
    for (QEvent::Type type :
         {QEvent::KeyPress, QEvent::MouseMove, QEvent::MouseButtonRelease, QEvent::Paint}) {
        QEvent event(type);
        QCoreApplication::sendEvent(&receiver, &event);
    }
    EXPECT_EQ(count.value(), 2u) << "moves do not count";
}

}  // namespace
