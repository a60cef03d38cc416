// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/window_progress.h"

#include <QApplication>
#include <QMainWindow>
#include <QProgressBar>
#include <QStatusBar>

namespace meshlab_host {
namespace {

constexpr qint64 milliseconds_between = 100;

QStatusBar* statusBarWithProgress() {
    if (!qobject_cast<QApplication*>(QCoreApplication::instance())) return nullptr;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (qobject_cast<QMainWindow*>(widget))
            for (auto* status : widget->findChildren<QStatusBar*>())
                if (status->findChild<QProgressBar*>()) return status;
    return nullptr;
}

}  // namespace

WindowProgress::WindowProgress() : status_(statusBarWithProgress()) {
    if (status_) bar_ = status_->findChild<QProgressBar*>();
    since_shown_.start();
}

WindowProgress::~WindowProgress() {
    if (is_shown_ && status_) {
        if (bar_) bar_->reset();
        status_->clearMessage();
    }
    if (views_) views_->setUpdatesEnabled(true);
}

/// Painting at once, as progress bars do, also paints all that waits in the window, even views of
/// the mesh being worked on. These are painted later, and panels now: they would stay blank until
/// their turn.
void WindowProgress::letViewsWait() {
    const auto* window = qobject_cast<QMainWindow*>(status_->window());
    QWidget* const views = window ? window->centralWidget() : nullptr;
    if (views_ || !views || !views->updatesEnabled()) return;
    views->setUpdatesEnabled(false);
    views_ = views;
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
    letViewsWait();
    bar_->show();
    bar_->setEnabled(true);
    const int range = bar_->maximum() - bar_->minimum();
    bar_->setValue(bar_->minimum() + int(done * range));
    status_->showMessage(QString("Laplacian Lines: %1").arg(stage));
    status_->repaint();
    bar_->repaint();
}

}  // namespace meshlab_host
