// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown at the foot of the window while lines are made ready.
#include "meshlab_host/window_progress.h"

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QMainWindow>
#include <QProgressBar>
#include <QStatusBar>
#include <QThread>

#include "event_loop.h"

namespace {

using meshlab_host::WindowProgress;

/// Counts its paint events.
template <class Widget>
class Counting : public Widget {
public:
    int paints = 0;

protected:
    void paintEvent(QPaintEvent* event) override {
        ++paints;
        Widget::paintEvent(event);
    }
};

/// Like MeshLab's.
class WindowProgressTest : public testing::Test {
protected:
    WindowProgressTest() : bar_(new Counting<QProgressBar>) {
        window_.statusBar()->addPermanentWidget(bar_);
        window_.resize(400, 100);
        window_.show();
        wait(50);
        bar_->reset();
    }
    /// Repeatedly, for this long.
    static void report(const laplacian_lines::Progress& progress, double done,
                       int milliseconds = 250) {
        QElapsedTimer clock;
        for (clock.start(); clock.elapsed() < milliseconds; QThread::msleep(5))
            EXPECT_TRUE(progress(done, "normals"));
    }

    QMainWindow window_;
    Counting<QProgressBar>* const bar_;
};

TEST_F(WindowProgressTest, MovesTheBarAndSaysWhatIsDone) {
    const int before = bar_->paints;
    WindowProgress progress;
    report(progress.step(0.5, 1), 0.5);
    EXPECT_EQ(bar_->value(), 75);
    EXPECT_EQ(window_.statusBar()->currentMessage(), "Laplacian Lines: normals");
    EXPECT_GT(bar_->paints, before) << "no event loop has run";
}

TEST_F(WindowProgressTest, IsGoneAfterwards) {
    {
        WindowProgress progress;
        report(progress.step(0, 1), 0.3);
    }
    EXPECT_LT(bar_->value(), 0);
    EXPECT_EQ(window_.statusBar()->currentMessage(), "");
}

/// Such as a redraw within the work, or the end of the mesh.
TEST_F(WindowProgressTest, LetsNothingElseHappen) {
    bool has_happened = false;
    QTimer::singleShot(0, &window_, [&] { has_happened = true; });
    WindowProgress progress;
    report(progress.step(0, 1), 0.3);
    EXPECT_EQ(bar_->value(), 30);
    EXPECT_FALSE(has_happened);
    wait(20);
    EXPECT_TRUE(has_happened);
}

/// Panels that wait for painting would be blank.
TEST_F(WindowProgressTest, KeepsPanelsOnTheScreen) {
    auto* const dock = new QDockWidget;
    auto* const panel = new Counting<QWidget>;
    dock->setWidget(panel);
    window_.addDockWidget(Qt::RightDockWidgetArea, dock);
    wait(50);
    panel->update();
    const int before = panel->paints;
    WindowProgress progress;
    report(progress.step(0, 1), 0.3);
    EXPECT_TRUE(panel->updatesEnabled());
    EXPECT_GT(panel->paints, before);
}

TEST_F(WindowProgressTest, DoesNotPaintViews) {
    auto* const view = new Counting<QWidget>;
    window_.setCentralWidget(view);
    wait(50);
    view->update();
    const int before = view->paints;
    {
        WindowProgress progress;
        report(progress.step(0, 1), 0.3);
    }
    EXPECT_EQ(view->paints, before);
    wait(50);
    EXPECT_GT(view->paints, before);
}

TEST_F(WindowProgressTest, IsNotShownForShortWork) {
    window_.statusBar()->showMessage("MeshLab's own");
    {
        WindowProgress progress;
        progress.step(0, 1)(0.5, "normals");
        EXPECT_LT(bar_->value(), 0);
    }
    EXPECT_EQ(window_.statusBar()->currentMessage(), "MeshLab's own");
}

TEST(WindowProgress, NeedsNoWindow) {
    WindowProgress progress;
    EXPECT_FALSE(progress.step(0, 1));
    QMainWindow window;
    window.statusBar()->showMessage("Ready");
    WindowProgress without_bar;
    EXPECT_FALSE(without_bar.step(0, 1));
}

}  // namespace
