// SPDX-License-Identifier: GPL-3.0-or-later
// The commands are described in README.md.
#include <QRegularExpression>
#include "command_table.h"
#include "gui.h"

namespace driver {
namespace {

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

void addLogCommands(CommandTable& table) {
    table.addSimple("log", [](const Command& c) { writeFile(c.rest, logText().toUtf8()); });
    table.add("expect-log", expectLog);
    table.addSimple("expect-no-log", expectNoLog);
}

}  // namespace driver
