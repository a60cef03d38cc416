// SPDX-License-Identifier: GPL-3.0-or-later
// The commands are described in README.md.
#include <QElapsedTimer>
#include <QFile>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTextEdit>
#include "gui.h"
#include "log_text.h"
#include "modules.h"

namespace driver {
namespace {

constexpr qint64 longest_wait = 5000;  // ms

/// MeshLab hides it when a document is closed, and writes no log while it is hidden.
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

namespace {

void dumpLog(const Command& command) {
    QFile file(command.rest);
    const QByteArray text = logText().toUtf8();
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        throw CommandError(QString("cannot write %1").arg(command.rest));
}

bool logHas(const QString& pattern) {
    const QRegularExpression expression(pattern);
    if (!expression.isValid())
        throw CommandError("this is not a regular expression: " + expression.errorString());
    return logText().contains(expression);
}

/// Some lines come with a redraw, which is late on a busy machine.
Outcome expectLog(const Command& command) {
    static int line = 0;
    static QElapsedTimer waiting;
    if (line != command.line) {
        line = command.line;
        waiting.start();
    }
    if (logHas(command.rest)) return Outcome::Done;
    if (waiting.elapsed() < longest_wait) return Outcome::Retry;
    throw CommandError("the log does not say so; it says:\n" + logText());
}

void expectNoLog(const Command& command) {
    if (logHas(command.rest)) throw CommandError("the log says so:\n" + logText());
}

}  // namespace

void addLogCommands(CommandTable& table) {
    table.addSimple("log", dumpLog);
    table.add("expect-log", expectLog);
    table.addSimple("expect-no-log", expectNoLog);
}

}  // namespace driver
