// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QAction>
#include <QGLWidget>
#include <QMainWindow>
#include <QString>
#include <QStringList>
#include <QWidget>

class MeshDocument;

// MeshLab's widgets by class name: the executable exports no symbols.
namespace driver {

QMainWindow* mainWindow();         // null before it exists
QMainWindow* requireMainWindow();  // CommandError when there is none

// Of the current document: the chosen one of the GL views from upper left to lower right, the first
// by default. Null when there is none.
QGLWidget* view();
QGLWidget* requireView();
void chooseView(int index);
MeshDocument* shownDocument();  // the view's; null without one

QWidget* filterDialog();                      // CommandError when none is open
QAction* requireAction(const QString& text);  // without '&' and shortcut; CommandError
void clickButton(QWidget* container, const QString& text);
QString withoutMnemonic(QString text);  // no '&', no shortcut

QString describeBox(QWidget* modal);    // title and text, on one line
bool acceptOptionsBox(QWidget* modal);  // of a reader of meshes, as they are; false: another box
void answerBox(QWidget* modal);         // yes, OK, or closed
QStringList takeAnsweredTexts();        // of the boxes answered since the last call

QString logText();  // all of MeshLab's log panel; CommandError when there is none

}  // namespace driver
