// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFocusEvent>
#include <QGuiApplication>
#include <QMdiArea>
#include <QRegularExpression>
#include <QScreen>
#include <QTreeWidget>
#include "camera.h"
#include "gui.h"
#include "process.h"

namespace driver {
namespace {

Outcome waitForView(const Command&) {
    return view() ? Outcome::Done : Outcome::Retry;
}

// Docked dialogs keep the view from getting small, and change its size when they come and go: put
// them beside it.
void undockDialogs(const QSize& windowSize) {
    int left = windowSize.width();
    for (QDockWidget* dock : requireMainWindow()->findChildren<QDockWidget*>()) {
        if (!dock->isVisible()) continue;
        dock->setFloating(true);
        dock->move(left, 0);
        left += dock->width();
    }
}

// Whether window and view have had these sizes for a while.
bool stoodStill(const QSize& window, const QSize& view) {
    constexpr qint64 a_while = 500;  // ms
    static QSize last_window, last_view;
    static QElapsedTimer since;
    if (!since.isValid() || window != last_window || view != last_view) {
        last_window = window;
        last_view = view;
        since.start();
    }
    return since.elapsed() >= a_while;
}

// The main window follows the view: the bars around it have sizes of their own, which settle after
// some events. Before, a window may seem to be too small.
Outcome setViewSize(const Command& command) {
    const QSize wanted = command.size(0);
    QMainWindow* window = requireMainWindow();
    if (window->isMaximized() || window->isFullScreen()) window->showNormal();
    QGLWidget* area = requireView();
    undockDialogs(window->size() + wanted - area->size());
    if (area->size() == wanted) return Outcome::Done;
    const QSize needed = window->size() + wanted - area->size();
    if (needed.width() < window->minimumSizeHint().width() ||
        needed.height() < window->minimumSizeHint().height()) {
        if (!stoodStill(window->size(), area->size())) return Outcome::Retry;
        throw CommandError(
            QString("MeshLab's window does not get so small; at least %1x%2")
                .arg(window->minimumSizeHint().width() - window->width() + area->width())
                .arg(window->minimumSizeHint().height() - window->height() + area->height()));
    }
    window->setGeometry(QRect(QPoint(0, 0), needed));
    return Outcome::Retry;
}

void openMesh(const Command& command) {
    bool opened = false;
    if (!QMetaObject::invokeMethod(requireMainWindow(), "importMeshWithLayerManagement",
                                   Qt::DirectConnection, Q_RETURN_ARG(bool, opened),
                                   Q_ARG(QString, command.rest)))
        throw CommandError("MeshLab's main window has no slot to import a mesh");
    if (!opened) throw CommandError("MeshLab could not open the mesh");
}

void makeCurrent(const Command& command) {
    chooseView(int(command.number(0)));
    // MeshLab takes the view that got the focus last; a display without window manager may hand out
    // none
    requireView()->setFocus();
    QFocusEvent event(QEvent::FocusIn, Qt::OtherFocusReason);
    QApplication::sendEvent(requireView(), &event);
}

void makeDocumentCurrent(const Command& command) {
    const QList<QMdiSubWindow*> windows = documentWindows();
    const int index = int(command.number(0));
    if (index < 0 || index >= windows.size())
        throw CommandError(QString("there are %1 documents, counted from 0").arg(windows.size()));
    windows[index]->mdiArea()->setActiveSubWindow(windows[index]);
}

void expectViews(const Command& command) {
    const int count = visibleViews().size();
    if (count != int(command.number(0)))
        throw CommandError(QString("there are %1 views").arg(count));
}

void invokeSlot(const Command& command) {
    QObject* object = nullptr;
    if (command.word(0) == "window")
        object = requireMainWindow();
    else if (command.word(0) == "view")
        object = requireView();
    else
        throw CommandError("say window or view");
    const QByteArray slot = command.word(1).toLatin1();
    const bool invoked =
        command.words.size() > 2
            ? QMetaObject::invokeMethod(object, slot, Q_ARG(QString, command.word(2)))
            : QMetaObject::invokeMethod(object, slot);
    if (!invoked) throw CommandError("there is no such slot");
}

// MeshLab's layer list shows an eye, a number and a name, with a star when the layer was changed.
enum LayerColumn { Eye, Number, Name };

bool isLayer(const QTreeWidgetItem* item, const QString& which) {
    QString name = item->text(Name);
    if (name.endsWith(" *")) name.chop(2);
    return name == which || item->text(Number) == which;
}

void clickLayer(const Command& command, LayerColumn column) {
    auto* tree = requireMainWindow()->findChild<QTreeWidget*>("meshTreeWidget");
    QStringList layers;
    for (int i = 0; tree && i < tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = tree->topLevelItem(i);
        layers << QString("'%1' (%2)").arg(item->text(Name), item->text(Number));
        if (isLayer(item, command.rest)) {
            emit tree->itemPressed(item, column);
            return;
        }
    }
    throw CommandError(QString("no layer '%1' among %2").arg(command.rest, layers.join(", ")));
}

void deleteLayer(const Command& command) {
    clickLayer(command, Name);
    requireAction("Delete Current Mesh")->trigger();
}

/// As users do, while the views have yet to be redrawn. Ends the process, or the time limit does.
Outcome leave(const Command&) {
    static bool is_closed = false;
    if (is_closed) return Outcome::Retry;
    const BoxAnswerer boxes;
    for (QGLWidget* shown : visibleViews())
        shown->update();
    is_closed = requireMainWindow()->close();
    if (!is_closed) throw CommandError("MeshLab's window does not close");
    return Outcome::Retry;
}

void save(const QImage& picture, const QString& file_name) {
    if (picture.isNull() || !picture.save(file_name))
        throw CommandError(QString("cannot write the picture %1").arg(file_name));
    say(QString("%1: %2x%3")
            .arg(file_name)
            .arg(picture.width())
            .arg(picture.height())
            .toStdString());
}

// repaint, not updateGL: MeshLab draws in paintEvent, and updateGL only clears
void grabView(const Command& command) {
    QGLWidget* area = requireView();
    area->repaint();
    save(area->grabFrameBuffer(), command.rest);
}

void grabScreen(const Command& command) {
    if (QGLWidget* area = view()) area->repaint();
    save(QGuiApplication::primaryScreen()->grabWindow(0).toImage(), command.rest);
}

bool logHas(const QString& pattern) {
    const QRegularExpression expression(pattern);
    if (!expression.isValid())
        throw CommandError("this is not a regular expression: " + expression.errorString());
    return logText().contains(expression);
}

/// Some lines come with a redraw, late on a busy machine.
Outcome expectLog(const Command& command) {
    if (logHas(command.rest)) return Outcome::Done;
    return retryAWhile(command, "the log does not say so; it says:\n" + logText());
}

void expectNoLog(const Command& command) {
    if (logHas(command.rest)) throw CommandError("the log says so:\n" + logText());
}

}  // namespace

void addWindowCommands(CommandTable& table) {
    table.addSimple("grab", grabView);
    table.addSimple("screen", grabScreen, Place::ModalBox);
    table.add("wait", waitForView);
    table.add("size", setViewSize);
    table.addSimple("open", openMesh);
    table.addSimple("view", makeCurrent);
    table.addSimple("document", makeDocumentCurrent);
    table.addSimple("expect-views", expectViews);
    table.addSimple("camera", [](const Command& c) { loadCamera(c.rest); });
    table.addSimple("save-camera", [](const Command& c) { saveCamera(c.rest); });
    table.addSimple("look", [](const Command& c) { lookFrom(c); });
    table.addSimple("slot", invokeSlot);
    table.add("leave", leave, Place::Everywhere);
    table.addSimple("select-layer", [](const Command& c) { clickLayer(c, Name); });
    table.addSimple("show-layer", [](const Command& c) { clickLayer(c, Eye); });
    table.addSimple("delete-layer", deleteLayer);
    table.addSimple("log", [](const Command& c) { writeFile(c.rest, logText().toUtf8()); });
    table.add("expect-log", expectLog);
    table.addSimple("expect-no-log", expectNoLog);
}

}  // namespace driver
