// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QMenu>
#include <QTreeWidget>
#include "command_table.h"
#include "fields.h"
#include "gui.h"

namespace driver {
namespace {

QAction* enabledAction(const QString& text) {
    QAction* action = requireAction(text);
    if (!action->isEnabled()) throw CommandError(QString("the action '%1' is disabled").arg(text));
    return action;
}

void triggerAction(const Command& command) {
    enabledAction(command.rest)->trigger();
}

void checkAction(const Command& command) {
    const QString state = command.rest.section(' ', -1);
    QAction* action = enabledAction(command.rest.section(' ', 0, -2));
    if (state != "on" && state != "off") throw CommandError("say on or off after the action");
    if (!action->isCheckable()) throw CommandError("the action is not checkable");
    if (action->isChecked() != (state == "on")) action->trigger();
}

void expectAction(const Command& command) {
    const QString state = command.rest.section(' ', -1);
    const bool has_state = state == "checked" || state == "unchecked";
    QAction* action = requireAction(has_state ? command.rest.section(' ', 0, -2) : command.rest);
    if (has_state && action->isChecked() != (state == "checked"))
        throw CommandError(QString("it is %1").arg(action->isChecked() ? "checked" : "unchecked"));
}

// MeshLab's search box lists actions in a menu.
void searchAndTrigger(const Command& command) {
    QMenu* menu = nullptr;
    for (QWidget* widget : QApplication::allWidgets())
        if (widget->inherits("SearchMenu")) menu = qobject_cast<QMenu*>(widget);
    const QString words = command.rest.section('=', 0, 0).trimmed();
    if (!menu || !QMetaObject::invokeMethod(menu, "edited", Q_ARG(QString, words)))
        throw CommandError("MeshLab has no search box");
    QStringList found;
    for (QAction* action : menu->actions()) {
        found << "'" + withoutMnemonic(action->text()) + "'";
        if (withoutMnemonic(action->text()) == command.rest.section('=', 1).trimmed())
            return action->trigger();
    }
    throw CommandError("the search finds only " + found.join(", "));
}

void setDecorationParameter(const Command& command) {
    auto* tree = requireMainWindow()->findChild<QTreeWidget*>("decParsTree");
    if (!tree) throw CommandError("the layer dialog shows no decoration parameters");
    setFieldFromCommand(tree, command);
}

}  // namespace

void addActionCommands(CommandTable& table) {
    table.addSimple("trigger", triggerAction);
    table.addSimple("search", searchAndTrigger);
    table.addSimple("check", checkAction);
    table.addSimple("expect-action", expectAction);
    table.addSimple("set", [](const Command& c) { setFieldFromCommand(filterDialog(), c); });
    table.addSimple("apply", [](const Command&) { clickButton(filterDialog(), "Apply"); });
    table.addSimple("close", [](const Command&) { clickButton(filterDialog(), "Close"); });
    table.addSimple("defaults", [](const Command&) { clickButton(filterDialog(), "Default"); });
    table.addSimple("setdeco", setDecorationParameter);
}

}  // namespace driver
