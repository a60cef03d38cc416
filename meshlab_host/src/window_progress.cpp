// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/window_progress.h"

#include <QApplication>
#include <QMainWindow>
#include <QProgressBar>
#include <QStatusBar>
#include <vector>

namespace meshlab_host {
namespace {

constexpr qint64 milliseconds_between = 100;

/// That of the main window which has a progress bar in it.
QStatusBar* statusBarWithProgress() {
    if (!qobject_cast<QApplication*>(QCoreApplication::instance())) return nullptr;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (qobject_cast<QMainWindow*>(widget))
            for (auto* status : widget->findChildren<QStatusBar*>())
                if (status->findChild<QProgressBar*>()) return status;
    return nullptr;
}

/// While it lives, nothing in the window but the status bar is painted. Whatever is painted at
/// once, as progress bars are when their value changes, takes along all that waits for it in the
/// window, views of the mesh that is worked on among it. These are painted later.
class OthersWait {
public:
    explicit OthersWait(const QStatusBar& status) {
        for (QObject* child : status.window()->children()) {
            auto* widget = qobject_cast<QWidget*>(child);
            if (!widget || widget == &status || !widget->updatesEnabled()) continue;
            widget->setUpdatesEnabled(false);
            waiting_.push_back(widget);
        }
    }
    ~OthersWait() {
        for (QWidget* widget : waiting_)
            widget->setUpdatesEnabled(true);
    }
    OthersWait(const OthersWait&) = delete;
    OthersWait& operator=(const OthersWait&) = delete;

private:
    std::vector<QWidget*> waiting_;
};

}  // namespace

WindowProgress::WindowProgress() : status_(statusBarWithProgress()) {
    if (status_) bar_ = status_->findChild<QProgressBar*>();
    since_shown_.start();
}

WindowProgress::~WindowProgress() {
    if (!is_shown_ || !status_) return;
    const OthersWait others_wait(*status_);
    if (bar_) bar_->reset();
    status_->clearMessage();
}

laplacian_lines::Progress WindowProgress::step(double begin, double end) {
    if (!status_ || !bar_) return {};
    return [=](double done, const char* stage) {
        show(begin + (end - begin) * done, stage);
        return true;
    };
}

void WindowProgress::show(double done, const char* stage) {
    if (!status_ || !bar_ || since_shown_.elapsed() < milliseconds_between) return;
    since_shown_.start();
    is_shown_ = true;
    const OthersWait others_wait(*status_);
    bar_->show();
    bar_->setEnabled(true);
    const int range = bar_->maximum() - bar_->minimum();
    bar_->setValue(bar_->minimum() + int(done * range));
    status_->showMessage(QString("Laplacian Lines: %1").arg(stage));
    status_->repaint();
    bar_->repaint();
}

}  // namespace meshlab_host
