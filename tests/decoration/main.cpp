// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>

/// Widgets and timers without a display.
int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    // Qt's platforms leak, which sanitizers would report even when tests are only listed.
    if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication program(argc, argv);
    return RUN_ALL_TESTS();
}
