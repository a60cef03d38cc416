// SPDX-License-Identifier: GPL-3.0-or-later
// Commands for the main window and its views: their size, mouse, layers, log and pictures.
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFocusEvent>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QTreeWidget>

#include "command_table.h"
#include "gui.h"

namespace driver {
namespace {

// Docked dialogs keep the view from getting small, and change its size when they come and go: put
// them beside it.
void undock_dialogs(const QSize& window_size) {
    int left = window_size.width();
    for (QDockWidget* dock : require_main_window()->findChildren<QDockWidget*>()) {
        if (!dock->isVisible()) continue;
        dock->setFloating(true);
        dock->move(left, 0);
        left += dock->width();
    }
}

// The main window follows the view: the bars around it have sizes of their own, which settle after
// some events. Before, a window may seem to be too small.
void set_view_size(const Command& command) {
    constexpr qint64 settled = 2000;  // ms
    static QElapsedTimer waiting;
    static int line = 0;
    if (line != command.line) waiting.start();
    line = command.line;
    const QStringList parts = command.rest.split('x');
    const QSize wanted(parts.value(0).toInt(), parts.value(1).toInt());
    if (wanted.isEmpty()) throw CommandError("say WIDTHxHEIGHT");
    QMainWindow* window = require_main_window();
    if (window->isMaximized() || window->isFullScreen()) window->showNormal();
    QGLWidget* area = require_view();
    const QSize needed = window->size() + wanted - area->size();
    undock_dialogs(needed);
    if (area->size() == wanted) return;
    const QSize least = window->minimumSizeHint(), around = window->size() - area->size();
    if (needed.expandedTo(least) == needed)
        window->setGeometry(QRect(QPoint(0, 0), needed));
    else if (waiting.elapsed() > settled)
        throw CommandError(QString("MeshLab's window does not get so small; at least %1x%2")
                               .arg(least.width() - around.width())
                               .arg(least.height() - around.height()));
    throw NotYet();
}

void make_view_current(const Command& command) {
    choose_view(int(command.number(0)));
    // MeshLab takes the view that got the focus last; a display without window manager may hand out
    // none
    require_view()->setFocus();
    QFocusEvent event(QEvent::FocusIn, Qt::OtherFocusReason);
    QApplication::sendEvent(require_view(), &event);
}

// MeshLab's layer list shows an eye, a number and a name, with a star when the layer was changed.
enum LayerColumn { Eye, Number, Name };

void click_layer(const Command& command, LayerColumn column) {
    auto* tree = require_main_window()->findChild<QTreeWidget*>("meshTreeWidget");
    for (int i = 0; tree && i < tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = tree->topLevelItem(i);
        if (item->text(Number) != command.rest) continue;
        emit tree->itemPressed(item, column);
        return;
    }
    throw CommandError(QString("no layer %1").arg(command.rest));
}

/// As users do, while the view has yet to be redrawn: the exit code is MeshLab's own.
void leave(const Command&) {
    static bool is_closed = false;
    if (!is_closed) {
        require_view()->update();
        is_closed = require_main_window()->close();
        if (!is_closed) throw CommandError("MeshLab's window does not close");
    }
    throw NotYet();
}

// repaint, not updateGL: MeshLab draws in paintEvent, and updateGL only clears
void grab(const Command& command) {
    QGLWidget* area = require_view();
    area->repaint();
    if (!area->grabFrameBuffer().save(command.rest))
        throw CommandError("cannot write the picture " + command.rest);
}

bool log_has(const Command& command) {
    return log_text().contains(QRegularExpression(command.rest));
}

void sleep(const Command& command) {
    static QElapsedTimer sleeping;
    if (!sleeping.isValid()) sleeping.start();
    if (sleeping.elapsed() < command.number(0)) throw NotYet();
    sleeping.invalidate();
}

void send_mouse(QEvent::Type type, QPointF point) {
    QGLWidget* area = require_view();
    const bool is_move = type == QEvent::MouseMove;
    const Qt::MouseButtons held =
        type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, point, area->mapToGlobal(point.toPoint()),
                      is_move ? Qt::NoButton : Qt::LeftButton, held, Qt::NoModifier);
    QApplication::sendEvent(area, &event);
    area->repaint();
}

// X0 Y0 X1 Y1, in fractions of the view
void drag(const Command& command) {
    const QSizeF size = require_view()->size();
    const auto point = [&](int first) {
        return QPointF(command.number(first) * size.width(),
                       command.number(first + 1) * size.height());
    };
    const QPointF from = point(0), to = point(2);
    constexpr int moves = 12;  // a trackball follows the path, not only its end
    send_mouse(QEvent::MouseButtonPress, from);
    for (int i = 1; i <= moves; ++i)
        send_mouse(QEvent::MouseMove, from + (to - from) * i / moves);
    send_mouse(QEvent::MouseButtonRelease, to);
}

}  // namespace

void add_window_commands(CommandTable& table) {
    table["wait"] = {[](const Command&) {
        if (!view()) throw NotYet();
    }};
    table["size"] = {set_view_size};
    table["view"] = {make_view_current};
    table["select-layer"] = {[](const Command& c) { click_layer(c, Name); }};
    table["show-layer"] = {[](const Command& c) { click_layer(c, Eye); }};
    table["drag"] = {drag};
    table["grab"] = {grab};
    table["expect-log"] = {[](const Command& c) {
        if (!log_has(c)) throw NotYet();  // some lines come with a redraw, late on a busy machine
    }};
    table["expect-no-log"] = {[](const Command& c) {
        if (log_has(c)) throw CommandError("the log says so");
    }};
    table["sleep"] = {sleep, Boxes::Subject};
    table["leave"] = {leave, Boxes::Answered};
}

}  // namespace driver
