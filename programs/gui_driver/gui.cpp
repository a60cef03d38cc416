// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include "gui.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QMdiArea>
#include <QMdiSubWindow>
#include <QMessageBox>
#include <QPointer>
#include <algorithm>
#include <cstring>
#include <utility>

#include "command_table.h"
#include "meshlab_host/documents.h"

namespace driver {
namespace {

int chosen_view = 0;
QStringList answered_texts;

bool is_of_class(const QObject* object, const char* class_name) {
    return std::strcmp(object->metaObject()->className(), class_name) == 0;
}

/// A visible descendant of the main window, or null.
QWidget* child_of_class(const char* class_name) {
    for (QWidget* widget : require_main_window()->findChildren<QWidget*>())
        if (is_of_class(widget, class_name) && widget->isVisible()) return widget;
    return nullptr;
}

QList<QGLWidget*> visible_views() {
    QList<QGLWidget*> views;
    const auto* area = main_window() ? main_window()->findChild<QMdiArea*>() : nullptr;
    const QMdiSubWindow* document = area ? area->currentSubWindow() : nullptr;
    if (!document) return views;
    for (QGLWidget* widget : document->findChildren<QGLWidget*>())
        if (is_of_class(widget, "GLArea") && widget->isVisible()) views << widget;
    std::sort(views.begin(), views.end(), [](QGLWidget* a, QGLWidget* b) {
        const QPoint p = a->mapToGlobal(QPoint()), q = b->mapToGlobal(QPoint());
        return std::make_pair(p.y(), p.x()) < std::make_pair(q.y(), q.x());
    });
    return views;
}

}  // namespace

QMainWindow* main_window() {
    static QPointer<QMainWindow> known;
    if (known) return known;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (is_of_class(widget, "MainWindow")) known = qobject_cast<QMainWindow*>(widget);
    return known;
}

QMainWindow* require_main_window() {
    QMainWindow* window = main_window();
    if (!window) throw CommandError("MeshLab has no main window");
    return window;
}

QGLWidget* view() {
    const QList<QGLWidget*> views = visible_views();
    if (views.isEmpty()) return nullptr;
    return views[qMin(chosen_view, int(views.size()) - 1)];
}

QGLWidget* require_view() {
    QGLWidget* widget = view();
    if (!widget) throw CommandError("MeshLab shows no GL view");
    return widget;
}

void choose_view(int index) {
    const int count = visible_views().size();
    if (index < 0 || index >= count)
        throw CommandError(QString("there are %1 views, counted from 0").arg(count));
    chosen_view = index;
}

// The scene shares objects with the view, and lives as long.
MeshDocument* shown_document() {
    QGLWidget* shown = view();
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* scene = qobject_cast<MLSceneGLSharedDataContext*>(widget))
            if (shown && QGLContext::areSharing(scene->context(), shown->context()))
                return &scene->meshDoc();
    return nullptr;
}

QWidget* filter_dialog() {
    for (const char* name : {"MeshlabStdDialog", "FilterDockDialog"})  // up to 2020.09, later
        if (QWidget* dialog = child_of_class(name)) return dialog;
    throw CommandError("no filter dialog is open");
}

QString without_mnemonic(QString text) {
    return text.remove('&').section('\t', 0, 0);
}

QAction* require_action(const QString& text) {
    // MeshLab enables actions late: a resized window can be split only after a menu update.
    QMetaObject::invokeMethod(require_main_window(), "updateMenus", Qt::DirectConnection);
    for (QWidget* widget : QApplication::allWidgets())
        for (QAction* action : widget->actions())
            if (without_mnemonic(action->text()) == text) return action;
    throw CommandError(QString("no action '%1'").arg(text));
}

void click_button(QWidget* container, const QString& text) {
    QStringList others;
    for (QAbstractButton* button : container->findChildren<QAbstractButton*>()) {
        if (without_mnemonic(button->text()) == text && button->isVisible()) return button->click();
        others << "'" + without_mnemonic(button->text()) + "'";
    }
    throw CommandError(QString("no button '%1' among %2").arg(text, others.join(", ")));
}

QString describe_box(QWidget* modal) {
    QString text = modal->windowTitle();
    if (const auto* box = qobject_cast<QMessageBox*>(modal)) text += ": " + box->text();
    return text.simplified();
}

bool accept_options_box(QWidget* modal) {
    auto* box = qobject_cast<QDialog*>(modal);
    if (!box || !is_of_class(box, "RichParameterListDialog")) return false;
    box->accept();
    return true;
}

void answer_box(QWidget* modal) {
    answered_texts << describe_box(modal);
    if (auto* box = qobject_cast<QMessageBox*>(modal))
        for (auto standard : {QMessageBox::Yes, QMessageBox::Ok})
            if (QAbstractButton* button = box->button(standard)) return button->click();
    modal->close();
}

QStringList take_answered_texts() {
    return std::exchange(answered_texts, {});
}

QString log_text() {
    QMainWindow* window = require_main_window();
    // MeshLab hides the panel with the last document, and writes no log while it is hidden.
    if (!child_of_class("LayerDialog"))
        QMetaObject::invokeMethod(window, "showLayerDlg", Qt::DirectConnection, Q_ARG(bool, true));
    QMetaObject::invokeMethod(window, "updateLayerDialog", Qt::DirectConnection);  // and the log
    if (const auto* panel = window->findChild<QWidget*>("logPlainTextEdit"))
        return panel->property("plainText").toString();  // of a QTextEdit or QPlainTextEdit
    throw CommandError("MeshLab's log panel was not found");
}

}  // namespace driver
