// SPDX-License-Identifier: GPL-3.0-or-later
// The commands are described in README.md.
#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>

#include "gui.h"
#include "modules.h"

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

void drag(const Command& command) {
    const QPointF from = pointInView(command, 0), to = pointInView(command, 2);
    const Qt::MouseButton button = buttonNamed(command.wordOr(4, "left"));
    const Qt::KeyboardModifiers modifiers = modifiersNamed(command.wordOr(5, ""));
    sendMouse(QEvent::MouseButtonPress, from, button, modifiers);
    const int moves = 12;  // a trackball follows the path, not only its end
    for (int i = 1; i <= moves; ++i)
        sendMouse(QEvent::MouseMove, from + (to - from) * i / moves, button, modifiers);
    sendMouse(QEvent::MouseButtonRelease, to, button, modifiers);
}

void turnWheel(double notches, Qt::KeyboardModifiers modifiers) {
    QGLWidget* area = requireView();
    const QPointF centre(area->width() / 2., area->height() / 2.);
    const int oneNotch = 120;
    QWheelEvent event(centre, area->mapToGlobal(centre.toPoint()), QPoint(),
                      QPoint(0, int(oneNotch * notches)), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(area, &event);
    area->repaint();
}

void wheel(const Command& command) {
    turnWheel(command.number(0), modifiersNamed(command.wordOr(1, "")));
}

/// Whether a frame along the view's border, a twentieth wide, shows nothing but one colour.
bool hasMargin() {
    QGLWidget* area = requireView();
    area->repaint();
    const QImage picture = area->grabFrameBuffer();
    const QRect all = picture.rect();
    const int margin = std::min(all.width(), all.height()) / 20;
    const QRect inside = all.adjusted(margin, margin, -margin, -margin);
    const int border = 2;  // MeshLab may outline the current view
    const QRect outside = all.adjusted(border, border, -border, -border);
    const QRgb background = picture.pixel(border, border);
    for (int y = outside.top(); y <= outside.bottom(); ++y)
        for (int x = outside.left(); x <= outside.right(); ++x)
            if (!inside.contains(x, y) && picture.pixel(x, y) != background) return false;
    return true;
}

void fillView(const Command&) {
    const double step = 0.25;       // notches
    const int most_steps = 8 * 12;  // a mesh that is nowhere to be seen must not keep us here
    for (int i = 0; i < most_steps && hasMargin(); ++i)
        turnWheel(-step, Qt::NoModifier);
    for (int i = 0; i < most_steps && !hasMargin(); ++i)
        turnWheel(step, Qt::NoModifier);
}

}  // namespace

void addMouseCommands(CommandTable& table) {
    table.addSimple("drag", drag);
    table.addSimple("press", [](const Command& c) { sendOne(QEvent::MouseButtonPress, c); });
    table.addSimple("move", [](const Command& c) { sendOne(QEvent::MouseMove, c); });
    table.addSimple("release", [](const Command& c) { sendOne(QEvent::MouseButtonRelease, c); });
    table.addSimple("wheel", wheel);
    table.addSimple("fill-view", fillView);
}

}  // namespace driver
