// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui.h"
#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QHash>
#include <QMdiArea>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QTextEdit>
#include <QTimer>
#include <algorithm>
#include <cstring>
#include "command_table.h"

namespace driver {
namespace {

int chosen_view = 0;

bool isOfClass(const QObject* object, const char* className) {
    return std::strcmp(object->metaObject()->className(), className) == 0;
}

}  // namespace

QMainWindow* mainWindow() {
    static QPointer<QMainWindow> known;  // there are thousands of widgets after some time
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

QList<QMdiSubWindow*> documentWindows() {
    auto* area = mainWindow() ? mainWindow()->findChild<QMdiArea*>() : nullptr;
    return area ? area->subWindowList() : QList<QMdiSubWindow*>();
}

QMdiSubWindow* currentDocumentWindow() {
    for (QMdiSubWindow* window : documentWindows())
        if (window->mdiArea()->currentSubWindow() == window) return window;
    return nullptr;
}

QList<QGLWidget*> visibleViews() {
    QList<QGLWidget*> views;
    if (QMdiSubWindow* window = currentDocumentWindow())
        for (QGLWidget* widget : window->findChildren<QGLWidget*>())
            if (isOfClass(widget, "GLArea") && widget->isVisible()) views << widget;
    std::sort(views.begin(), views.end(), [](QGLWidget* a, QGLWidget* b) {
        const QPoint p = a->mapToGlobal(QPoint()), q = b->mapToGlobal(QPoint());
        return std::make_pair(p.y(), p.x()) < std::make_pair(q.y(), q.x());
    });
    return views;
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

QWidget* childOfClass(const char* className) {
    for (QWidget* widget : requireMainWindow()->findChildren<QWidget*>())
        if (isOfClass(widget, className) && widget->isVisible()) return widget;
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

namespace {

bool hasText(const QAction* action, const QString& text) {
    return withoutMnemonic(action->text()) == text;
}

QAction* searchAction(const QString& text) {
    for (QWidget* widget : QApplication::allWidgets())
        for (QAction* action : widget->actions())
            if (hasText(action, text)) return action;
    return nullptr;
}

}  // namespace

QAction* findAction(const QString& text) {
    // MeshLab enables actions late: a resized window can be split only after a menu update.
    QMetaObject::invokeMethod(requireMainWindow(), "updateMenus", Qt::DirectConnection);
    static QHash<QString, QPointer<QAction>> known;
    QPointer<QAction>& action = known[text];
    if (!action || !hasText(action, text)) action = searchAction(text);
    return action;
}

QAction* requireAction(const QString& text) {
    if (QAction* action = findAction(text)) return action;
    QStringList alike;
    for (QWidget* widget : QApplication::allWidgets())
        for (QAction* action : widget->actions())
            if (action->text().contains(text.section(' ', 0, 0), Qt::CaseInsensitive))
                alike << "'" + withoutMnemonic(action->text()) + "'";
    alike.removeDuplicates();
    throw CommandError(QString("no action '%1'; similar: %2")
                           .arg(text, alike.isEmpty() ? "none" : alike.join(", ")));
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

namespace {

/// MeshLab hides it with the last document, and writes no log while it is hidden.
void showLayerDialog(QMainWindow* window) {
    if (!childOfClass("LayerDialog"))
        QMetaObject::invokeMethod(window, "showLayerDlg", Qt::DirectConnection, Q_ARG(bool, true));
}

}  // namespace

QString logText() {
    QMainWindow* window = requireMainWindow();
    showLayerDialog(window);
    QMetaObject::invokeMethod(window, "updateLayerDialog",
                              Qt::DirectConnection);  // it also refreshes the log panel
    if (const auto* panel = window->findChild<QPlainTextEdit*>("logPlainTextEdit"))
        return panel->toPlainText();
    if (const auto* panel = window->findChild<QTextEdit*>("logPlainTextEdit"))
        return panel->toPlainText();
    throw CommandError("MeshLab's log panel was not found");
}

constexpr int between_looks = 20;  // ms

BoxAnswerer::BoxAnswerer() {
    lookAgain();
}

QStringList BoxAnswerer::takeTexts() {
    QStringList taken;
    taken.swap(texts_);
    return taken;
}

// Armed before the answer, which may open the next box.
void BoxAnswerer::lookAgain() {
    QTimer::singleShot(between_looks, this, [this] {
        lookAgain();
        if (QWidget* modal = QApplication::activeModalWidget()) answer(modal);
    });
}

void BoxAnswerer::answer(QWidget* modal) {
    if (acceptOptionsBox(modal)) return;
    texts_ << describeBox(modal);
    if (auto* box = qobject_cast<QMessageBox*>(modal)) {
        for (auto standard : {QMessageBox::Yes, QMessageBox::Ok})
            if (QAbstractButton* button = box->button(standard)) return button->click();
    }
    modal->close();
}

}  // namespace driver
