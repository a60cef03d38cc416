// SPDX-License-Identifier: GPL-3.0-or-later
#include "press_count.h"

#include <QCoreApplication>
#include <QEvent>

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
