// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QGuiApplication>
#include <memory>

namespace {

/// PDF needs fonts. Not there while tests are only listed.
class Application : public testing::Environment {
public:
    Application(int& argc, char** argv) : argc_(argc), argv_(argv) {}
    void SetUp() override {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        application_ = std::make_unique<QGuiApplication>(argc_, argv_);
    }
    void TearDown() override { application_.reset(); }

private:
    int& argc_;
    char** argv_;
    std::unique_ptr<QGuiApplication> application_;
};

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    testing::AddGlobalTestEnvironment(new Application(argc, argv));  // GoogleTest owns it
    return RUN_ALL_TESTS();
}
