// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "command_table.h"
#include "gui.h"

namespace driver {
namespace {

Qt::MouseButton buttonNamed(const QString& name) {
    if (name == "left") return Qt::LeftButton;
    if (name == "middle") return Qt::MiddleButton;
    if (name == "right") return Qt::RightButton;
    throw CommandError(QString("no mouse button '%1'").arg(name));
}

Qt::KeyboardModifiers modifiersNamed(const QString& names) {
    Qt::KeyboardModifiers modifiers;
    for (const QString& name : names.split(',', Qt::SkipEmptyParts)) {
        if (name == "shift")
            modifiers |= Qt::ShiftModifier;
        else if (name == "ctrl")
            modifiers |= Qt::ControlModifier;
        else if (name == "alt")
            modifiers |= Qt::AltModifier;
        else
            throw CommandError(QString("no key '%1'").arg(name));
    }
    return modifiers;
}

QPointF pointInView(const Command& command, int first) {
    const QGLWidget* area = requireView();
    return QPointF(command.number(first) * area->width(),
                   command.number(first + 1) * area->height());
}

void sendMouse(QEvent::Type type, QPointF point, Qt::MouseButton button,
               Qt::KeyboardModifiers modifiers) {
    QGLWidget* area = requireView();
    const bool moving = type == QEvent::MouseMove;
    const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : button;
    QMouseEvent event(type, point, area->mapToGlobal(point.toPoint()),
                      moving ? Qt::NoButton : button, held, modifiers);
    QApplication::sendEvent(area, &event);
    area->repaint();
}

void sendOne(QEvent::Type type, const Command& command) {
    sendMouse(type, pointInView(command, 0), buttonNamed(command.wordOr(2, "left")),
              modifiersNamed(command.wordOr(3, "")));
}

void dragMouse(QPointF from, QPointF to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    sendMouse(QEvent::MouseButtonPress, from, button, modifiers);
    const int moves = 12;  // a trackball follows the path, not only its end
    for (int i = 1; i <= moves; ++i)
        sendMouse(QEvent::MouseMove, from + (to - from) * i / moves, button, modifiers);
    sendMouse(QEvent::MouseButtonRelease, to, button, modifiers);
}

void drag(const Command& command) {
    dragMouse(pointInView(command, 0), pointInView(command, 2),
              buttonNamed(command.wordOr(4, "left")), modifiersNamed(command.wordOr(5, "")));
}

void turnWheel(double notches, Qt::KeyboardModifiers modifiers) {
    QGLWidget* area = requireView();
    const QPointF centre(area->width() / 2., area->height() / 2.);
    const int one_notch = 120;
    QWheelEvent event(centre, area->mapToGlobal(centre.toPoint()), QPoint(),
                      QPoint(0, int(one_notch * notches)), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(area, &event);
    area->repaint();
}

void wheel(const Command& command) {
    turnWheel(command.number(0), modifiersNamed(command.wordOr(1, "")));
}

void pressKey(const Command&) {
    for (QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
        QKeyEvent event(type, Qt::Key_F24, Qt::NoModifier);
        QApplication::sendEvent(requireView(), &event);
    }
}

}  // namespace

void addMouseCommands(CommandTable& table) {
    table.addSimple("drag", drag);
    table.addSimple("press", [](const Command& c) { sendOne(QEvent::MouseButtonPress, c); });
    table.addSimple("move", [](const Command& c) { sendOne(QEvent::MouseMove, c); });
    table.addSimple("release", [](const Command& c) { sendOne(QEvent::MouseButtonRelease, c); });
    table.addSimple("wheel", wheel);
    table.addSimple("press-key", pressKey);
}

}  // namespace driver
