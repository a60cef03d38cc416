// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry_check.h"

#include <QCoreApplication>
#include <QEvent>
#include <QWidget>

PressCount::PressCount() {
    if (QCoreApplication* program = QCoreApplication::instance()) program->installEventFilter(this);
}

bool PressCount::eventFilter(QObject*, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::KeyRelease:
        case QEvent::Shortcut:
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonRelease:
        case QEvent::MouseButtonDblClick:
        case QEvent::TabletPress:
        case QEvent::TabletRelease:
        case QEvent::TouchBegin:
        case QEvent::TouchEnd:
        case QEvent::Drop:
            ++value_;
            break;
        default:
            break;
    }
    return false;
}

constexpr qint64 kMillisecondsBetweenChecks = 250;

GeometryCheck::GeometryCheck() {
    redraw_.setSingleShot(true);
    since_check_.start();
}

bool GeometryCheck::is_due(const Eigen::Matrix4d& modelview, unsigned presses, QWidget* widget) {
    const bool only_moved = modelview_ && *modelview_ != modelview && presses == presses_;
    modelview_ = modelview;
    presses_ = presses;
    const qint64 wait = kMillisecondsBetweenChecks - since_check_.elapsed();
    if (!widget || !only_moved || wait <= 0) {
        redraw_.stop();
        since_check_.start();
        return true;
    }
    if (!redraw_.isActive()) {
        redraw_.disconnect();
        QObject::connect(&redraw_, &QTimer::timeout, widget, [widget] { widget->update(); });
        redraw_.start(int(wait));
    }
    return false;
}
