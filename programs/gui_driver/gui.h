// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QAction>
#include <QGLWidget>
#include <QList>
#include <QMainWindow>
#include <QMdiSubWindow>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QWidget>

// MeshLab's widgets by class name: the executable exports no symbols.
namespace driver {

QMainWindow* mainWindow();         // null before it exists
QMainWindow* requireMainWindow();  // CommandError when there is none

QList<QMdiSubWindow*> documentWindows();
QMdiSubWindow* currentDocumentWindow();  // null when there is none

// GL views of the current document, from upper left to lower right.
QList<QGLWidget*> visibleViews();
QGLWidget* view();  // the chosen one (the first by default); null when there is none
QGLWidget* requireView();
void chooseView(int index);

QWidget* childOfClass(const char* className);  // a visible descendant of the main window, or null
QWidget* filterDialog();                       // CommandError when none is open
QString withoutMnemonic(QString text);         // no '&', no shortcut
QAction* requireAction(const QString& text);   // CommandError with look-alikes when there is none
QAction* findAction(const QString& text);
void clickButton(QWidget* container, const QString& text);

QString describeBox(QWidget* modal);  // title and text, on one line
bool acceptOptionsBox(
    QWidget* modal);  // accepts MeshLab's own "options" box on opening a file; false: another box

QString logText();  // all of MeshLab's log panel; CommandError when there is none

/// Answers modal boxes as they appear: accepts options, says yes, closes other dialogs.
class BoxAnswerer : public QObject {
public:
    BoxAnswerer();
    QStringList takeTexts();  ///< of the boxes answered since the last call

private:
    void lookAgain();
    void answer(QWidget* modal);

    QStringList texts_;
};

}  // namespace driver
