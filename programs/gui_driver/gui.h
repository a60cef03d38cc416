// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QGLWidget>
#include <QMainWindow>
#include <QString>
#include <QStringList>
#include <QWidget>

class MeshDocument;

/// MeshLab's widgets by class name: the executable exports no symbols.
namespace driver {

QMainWindow* main_window();          ///< null before it exists
QMainWindow* require_main_window();  ///< CommandError when there is none

/// The chosen GL view of the current document, counted from upper left to lower right; the first by
/// default, the last if there are fewer now. Null when there is none.
QGLWidget* view();
QGLWidget* require_view();       ///< CommandError when there is none
void choose_view(int index);     ///< CommandError when there are not so many
MeshDocument* shown_document();  ///< the view's; null without one

QWidget* filter_dialog();                      ///< CommandError when none is open
QAction* require_action(const QString& text);  ///< without '&' and shortcut; CommandError
void click_button(QWidget* container, const QString& text);
QString without_mnemonic(QString text);  ///< no '&', no shortcut

QString describe_box(QWidget* modal);  ///< title and text, on one line
/// Accepts the options of a reader of meshes as they are; false if it is another box.
bool accept_options_box(QWidget* modal);
void answer_box(QWidget* modal);    ///< yes, OK, or closed
QStringList take_answered_texts();  ///< of the boxes answered since the last call

QString log_text();  ///< all of MeshLab's log panel; CommandError when there is none

}  // namespace driver
