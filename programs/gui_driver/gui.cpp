// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include "gui.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QMdiArea>
#include <QMdiSubWindow>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPointer>
#include <QTextEdit>
#include <algorithm>
#include <cstring>

#include "command_table.h"
#include "meshlab_host/scene.h"

namespace driver {
namespace {

int chosen_view = 0;
QStringList answered_texts;

bool isOfClass(const QObject* object, const char* class_name) {
    return std::strcmp(object->metaObject()->className(), class_name) == 0;
}

/// A visible descendant of the main window, or null.
QWidget* childOfClass(const char* class_name) {
    for (QWidget* widget : requireMainWindow()->findChildren<QWidget*>())
        if (isOfClass(widget, class_name) && widget->isVisible()) return widget;
    return nullptr;
}

QList<QGLWidget*> visibleViews() {
    QList<QGLWidget*> views;
    const auto* area = mainWindow() ? mainWindow()->findChild<QMdiArea*>() : nullptr;
    const QMdiSubWindow* document = area ? area->currentSubWindow() : nullptr;
    if (!document) return views;
    for (QGLWidget* widget : document->findChildren<QGLWidget*>())
        if (isOfClass(widget, "GLArea") && widget->isVisible()) views << widget;
    std::sort(views.begin(), views.end(), [](QGLWidget* a, QGLWidget* b) {
        const QPoint p = a->mapToGlobal(QPoint()), q = b->mapToGlobal(QPoint());
        return std::make_pair(p.y(), p.x()) < std::make_pair(q.y(), q.x());
    });
    return views;
}

}  // namespace

QMainWindow* mainWindow() {
    static QPointer<QMainWindow> known;
    if (known) return known;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (isOfClass(widget, "MainWindow")) known = qobject_cast<QMainWindow*>(widget);
    return known;
}

QMainWindow* requireMainWindow() {
    QMainWindow* window = mainWindow();
    if (!window) throw CommandError("MeshLab has no main window");
    return window;
}

QGLWidget* view() {
    const QList<QGLWidget*> views = visibleViews();
    if (views.isEmpty()) return nullptr;
    return views[qMin(chosen_view, int(views.size()) - 1)];
}

QGLWidget* requireView() {
    QGLWidget* widget = view();
    if (!widget) throw CommandError("MeshLab shows no GL view");
    return widget;
}

void chooseView(int index) {
    const int count = visibleViews().size();
    if (index < 0 || index >= count)
        throw CommandError(QString("there are %1 views, counted from 0").arg(count));
    chosen_view = index;
}

// The scene shares objects with the view, and lives as long.
MeshDocument* shownDocument() {
    QGLWidget* shown = view();
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* scene = qobject_cast<MLSceneGLSharedDataContext*>(widget))
            if (shown && QGLContext::areSharing(scene->context(), shown->context()))
                return &scene->meshDoc();
    return nullptr;
}

QWidget* filterDialog() {
    for (const char* name : {"MeshlabStdDialog", "FilterDockDialog"})  // up to 2020.09, later
        if (QWidget* dialog = childOfClass(name)) return dialog;
    throw CommandError("no filter dialog is open");
}

QString withoutMnemonic(QString text) {
    return text.remove('&').section('\t', 0, 0);
}

QAction* requireAction(const QString& text) {
    // MeshLab enables actions late: a resized window can be split only after a menu update.
    QMetaObject::invokeMethod(requireMainWindow(), "updateMenus", Qt::DirectConnection);
    for (QWidget* widget : QApplication::allWidgets())
        for (QAction* action : widget->actions())
            if (withoutMnemonic(action->text()) == text) return action;
    throw CommandError(QString("no action '%1'").arg(text));
}

void clickButton(QWidget* container, const QString& text) {
    QStringList others;
    for (QAbstractButton* button : container->findChildren<QAbstractButton*>()) {
        if (withoutMnemonic(button->text()) == text && button->isVisible()) return button->click();
        others << "'" + withoutMnemonic(button->text()) + "'";
    }
    throw CommandError(QString("no button '%1' among %2").arg(text, others.join(", ")));
}

QString describeBox(QWidget* modal) {
    QString text = modal->windowTitle();
    if (const auto* box = qobject_cast<QMessageBox*>(modal)) text += ": " + box->text();
    return text.simplified();
}

bool acceptOptionsBox(QWidget* modal) {
    auto* box = qobject_cast<QDialog*>(modal);
    if (!box || !isOfClass(box, "RichParameterListDialog")) return false;
    box->accept();
    return true;
}

void answerBox(QWidget* modal) {
    answered_texts << describeBox(modal);
    if (auto* box = qobject_cast<QMessageBox*>(modal))
        for (auto standard : {QMessageBox::Yes, QMessageBox::Ok})
            if (QAbstractButton* button = box->button(standard)) return button->click();
    modal->close();
}

QStringList takeAnsweredTexts() {
    QStringList taken;
    taken.swap(answered_texts);
    return taken;
}

QString logText() {
    QMainWindow* window = requireMainWindow();
    // MeshLab hides the panel with the last document, and writes no log while it is hidden.
    if (!childOfClass("LayerDialog"))
        QMetaObject::invokeMethod(window, "showLayerDlg", Qt::DirectConnection, Q_ARG(bool, true));
    QMetaObject::invokeMethod(window, "updateLayerDialog", Qt::DirectConnection);  // and the log
    if (const auto* panel = window->findChild<QPlainTextEdit*>("logPlainTextEdit"))
        return panel->toPlainText();
    if (const auto* panel = window->findChild<QTextEdit*>("logPlainTextEdit"))
        return panel->toPlainText();
    throw CommandError("MeshLab's log panel was not found");
}

}  // namespace driver
