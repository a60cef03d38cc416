// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <QWidget>

/// Processes events for this long; 0: those that are pending.
inline void wait(int milliseconds) {
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Counts its redraws from when it has been shown on.
class CountingWidget : public QWidget {
public:
    CountingWidget() {
        show();
        QElapsedTimer clock;
        clock.start();
        while (redraws_ == 0 && clock.elapsed() < 5000)
            wait(5);
        wait(20);
        redraws_ = 0;
    }
    int redraws() const { return redraws_; }

protected:
    void paintEvent(QPaintEvent*) override { ++redraws_; }

private:
    int redraws_ = 0;
};
