// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QGuiApplication>

/// Fonts, for PDF, but no display.
int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    // Qt's platforms leak, which sanitizers would hold against a build that only lists the tests.
    if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
