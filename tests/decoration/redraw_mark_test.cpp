// SPDX-License-Identifier: GPL-3.0-or-later
// Each redraw of a view begins once, whatever is painted in between.
#include "redraw_mark.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

namespace {

TEST(RedrawMark, IsTheFirstCallWithAPainter) {
    QImage image(8, 8, QImage::Format_RGB32);
    for (int redraw = 0; redraw < 3; ++redraw) {
        EXPECT_TRUE(begins_redraw(nullptr));
        QPainter painter(&image);
        EXPECT_TRUE(begins_redraw(&painter));
        painter.setPen(Qt::red);
        painter.setBrush(Qt::blue);
        painter.drawRect(1, 1, 4, 4);
        EXPECT_FALSE(begins_redraw(&painter));
        painter.beginNativePainting();
        painter.endNativePainting();
        EXPECT_FALSE(begins_redraw(&painter));
    }
}

}  // namespace
