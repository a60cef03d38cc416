// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QLabel>
#include <QMainWindow>
#include <QRegularExpression>
#include <QTextDocument>
#include <QTreeWidget>
#include "command_table.h"
#include "fields.h"
#include "gui.h"
#include "process.h"

namespace driver {
namespace {

/// As if maximized on a screen of this size.
Outcome setWindowSize(const Command& command) {
    QMainWindow* window = requireMainWindow();
    if (window->isMaximized() || window->isFullScreen()) window->showNormal();
    const QSize wanted = command.size(0);
    if (window->size() == wanted) return Outcome::Done;
    window->setGeometry(QRect(QPoint(0, 0), wanted));
    return Outcome::Retry;
}

void expectWithin(const QString& what, const QSize& size, const Command& command) {
    const QSize most = command.size(0);
    const QString words = QString("%1 is %2x%3").arg(what).arg(size.width()).arg(size.height());
    say(words.toStdString());
    if (size.width() > most.width() || size.height() > most.height()) throw CommandError(words);
}

void expectDialogWithin(const Command& command) {
    expectWithin("the dialog", filterDialog()->frameGeometry().size(), command);
}

void expectWindowWithin(const Command& command) {
    expectWithin("the window", requireMainWindow()->size(), command);
}

QTreeWidget* decorationTree() {
    if (auto* tree = requireMainWindow()->findChild<QTreeWidget*>("decParsTree")) return tree;
    throw CommandError("the layer dialog shows no decoration parameters");
}

void unfoldDecoration(const Command& command) {
    const auto items = decorationTree()->findItems(command.rest, Qt::MatchExactly);
    if (items.isEmpty()) throw CommandError("the decoration has no parameters there");
    items.first()->setExpanded(true);
}

void expectDecorationField(const Command& command) {
    const QString wanted = command.rest.section(' ', -1);
    const QString state = stateOfField(decorationTree(), command.rest.section(' ', 0, -2));
    if (state != wanted) throw CommandError("it is " + state);
}

/// A label in red with a matching tool tip, or no label in red.
void expectFault(const Command& command) {
    const QString name = command.rest.section('=', 0, 0).trimmed();
    const QRegularExpression wanted(command.rest.section('=', 1).trimmed());
    for (const QLabel* label : decorationTree()->findChildren<QLabel*>()) {
        if (!label->text().endsWith(name)) continue;
        const bool is_red = label->palette().color(QPalette::WindowText) == Qt::red;
        if (is_red == wanted.pattern().isEmpty() || !label->toolTip().contains(wanted))
            throw CommandError((is_red ? "red: " : "not red: ") + label->toolTip());
        return;
    }
    throw CommandError("there is no such parameter");
}

/// The decorations' fields show without scrolling on a screen of this height.
void expectFieldsAbove(const Command& command) {
    const QTreeWidget* tree = decorationTree();
    const auto bottom = [](const QWidget* widget) {
        return widget->mapTo(widget->window(), QPoint(0, widget->height())).y();
    };
    int lowest = 0;
    for (const QLabel* label : tree->findChildren<QLabel*>())
        if (label->isVisible()) lowest = qMax(lowest, bottom(label));
    for (const QCheckBox* box : tree->findChildren<QCheckBox*>())
        if (box->isVisible()) lowest = qMax(lowest, bottom(box));
    const QString words = QString("the fields end at %1, their panel at %2")
                              .arg(lowest)
                              .arg(bottom(tree->viewport()));
    say(words.toStdString());
    if (lowest == 0 || lowest > command.number(0) || lowest > bottom(tree->viewport()))
        throw CommandError(words);
}

/// Qt wraps tool tips only if they are rich text.
void expectWrappedToolTips(const Command&) {
    int tool_tips = 0;
    for (QWidget* widget : decorationTree()->findChildren<QWidget*>()) {
        if (widget->toolTip().isEmpty()) continue;
        ++tool_tips;
        if (!Qt::mightBeRichText(widget->toolTip()))
            throw CommandError("one line: " + widget->toolTip());
    }
    if (!tool_tips) throw CommandError("there are no tool tips");
}

void expectField(const Command& command) {
    const QString wanted = command.rest.section('=', 1).trimmed();
    const QString shown = textOfField(filterDialog(), command.rest.section('=', 0, 0).trimmed());
    if (shown != wanted) throw CommandError(QString("it shows '%1'").arg(shown));
}

/// Some texts follow the typing after a pause.
Outcome expectInDialog(const Command& command) {
    QStringList texts;
    for (const QLabel* label : filterDialog()->findChildren<QLabel*>())
        if (label->isVisible()) texts << label->text();
    if (texts.join('\n').contains(QRegularExpression(command.rest))) return Outcome::Done;
    return retryAWhile(command, "the dialog does not say so; it says:\n" + texts.join('\n'));
}

}  // namespace

void addDialogCommands(CommandTable& table) {
    table.add("window", setWindowSize);
    table.addSimple("unfold", unfoldDecoration);
    table.addSimple("expect-deco", expectDecorationField);
    table.addSimple("expect-fields-above", expectFieldsAbove);
    table.addSimple("expect-fault", expectFault);
    table.addSimple("expect-wrapped-tool-tips", expectWrappedToolTips);
    table.addSimple("help", [](const Command&) { clickButton(filterDialog(), "Help"); });
    table.addSimple("click", [](const Command& c) { clickButton(filterDialog(), c.rest); });
    table.addSimple("expect-field", expectField);
    table.add("expect-in-dialog", expectInDialog);
    table.addSimple("expect-dialog-within", expectDialogWithin);
    table.addSimple("expect-window-within", expectWindowWithin);
}

}  // namespace driver
