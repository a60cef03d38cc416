// SPDX-License-Identifier: GPL-3.0-or-later
// Commands for menus, dialogs and boxes: fields are found by their labels, as a user finds them.
#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTimer>
#include <QTreeWidget>

#include "command_table.h"
#include "gui.h"

namespace driver {
namespace {

using Widgets = QList<QWidget*>;

void collect_widgets(QLayoutItem* item, Widgets& widgets) {
    if (!item) return;
    if (QWidget* widget = item->widget(); widget && !widgets.contains(widget)) widgets << widget;
    if (QLayout* layout = item->layout())
        for (int i = 0; i < layout->count(); ++i)
            collect_widgets(layout->itemAt(i), widgets);
}

/// A label and its editors share a grid's row.
Widgets editors_beside(QWidget* container, QLabel* label) {
    Widgets editors;
    for (QGridLayout* grid : container->findChildren<QGridLayout*>()) {
        if (grid->indexOf(label) < 0) continue;
        int row, column, row_span, column_span;
        grid->getItemPosition(grid->indexOf(label), &row, &column, &row_span, &column_span);
        for (int c = column + column_span; c < grid->columnCount(); ++c) {
            QLayoutItem* item = grid->itemAtPosition(row, c);
            if (item && qobject_cast<QLabel*>(item->widget())) break;  // of another field
            collect_widgets(item, editors);
        }
    }
    return editors;
}

Widgets find_editors(QWidget* container, const QString& name) {
    for (QCheckBox* box : container->findChildren<QCheckBox*>())  // up to 2020.09
        if (without_mnemonic(box->text()) == name) return {box};
    QStringList others;
    for (QLabel* label : container->findChildren<QLabel*>()) {
        const QString text = without_mnemonic(label->text()).trimmed();
        const Widgets editors = editors_beside(container, label);
        if (editors.isEmpty()) continue;  // a help text
        if (text == name) return editors;
        others << "'" + text + "'";
    }
    throw CommandError(QString("no field '%1' among %2").arg(name, others.join(", ")));
}

template <class Editor>
Editor* first_of(const Widgets& widgets) {
    for (QWidget* widget : widgets)
        if (auto* editor = qobject_cast<Editor*>(widget)) return editor;
    return nullptr;
}

void set_check_box(QCheckBox* box, const QString& value) {
    if (value != "on" && value != "off")
        throw CommandError(QString("a check box takes on or off, not '%1'").arg(value));
    if (box->isChecked() != (value == "on")) box->click();
}

void set_combo_box(QComboBox* box, const QString& value) {
    int index = box->findText(value);
    bool is_number = true;
    if (index < 0) index = value.toInt(&is_number);
    if (!is_number || index < 0 || index >= box->count()) {
        QStringList entries;
        for (int i = 0; i < box->count(); ++i)
            entries << "'" + box->itemText(i) + "'";
        throw CommandError(QString("no entry '%1' among %2").arg(value, entries.join(", ")));
    }
    box->setCurrentIndex(index);
    QMetaObject::invokeMethod(box, "activated", Q_ARG(int, index));  // as after a user's choice
}

void set_line_edit(QLineEdit* edit, const QString& value) {
    edit->setText(value);
    QMetaObject::invokeMethod(edit, "editingFinished");
    QMetaObject::invokeMethod(edit, "returnPressed");
}

// The button opens a modal box: arm the answer, then click.
void set_color(QPushButton* button, const QString& value) {
    const QColor color(value);
    if (!color.isValid()) throw CommandError(QString("'%1' is not a color").arg(value));
    QTimer::singleShot(0, button, [color] {
        if (auto* box = qobject_cast<QColorDialog*>(QApplication::activeModalWidget())) {
            box->setCurrentColor(color);
            box->accept();
        }
    });
    button->click();
}

/// LABEL = VALUE: sets the container's field with this label as a user would. Check box: on or off;
/// combo box: text or number of an entry; color: #rrggbb or a name.
void set_field(QWidget* container, const Command& command) {
    // Labels may contain '=', values do not.
    const QString name = command.rest.section('=', 0, -2).trimmed();
    const QString value = command.rest.section('=', -1).trimmed();
    const Widgets editors = find_editors(container, name);
    if (auto* check_box = first_of<QCheckBox>(editors))
        set_check_box(check_box, value);
    else if (auto* combo_box = first_of<QComboBox>(editors))
        set_combo_box(combo_box, value);
    else if (auto* edit = first_of<QLineEdit>(editors))
        set_line_edit(edit, value);
    else if (auto* button = first_of<QPushButton>(editors))
        set_color(button, value);
    else
        throw CommandError(QString("the field '%1' cannot be set").arg(name));
}

void trigger(const Command& command) {
    QAction* action = require_action(command.rest);
    if (!action->isEnabled()) throw CommandError("the action is disabled");
    action->trigger();
}

// ACTION on or off
void check(const Command& command) {
    const QString state = command.rest.section(' ', -1);
    QAction* action = require_action(command.rest.section(' ', 0, -2));
    if (state != "on" && state != "off") throw CommandError("say on or off after the action");
    if (!action->isEnabled() || !action->isCheckable())
        throw CommandError("the action is disabled or not checkable");
    if (action->isChecked() != (state == "on")) action->trigger();
}

// ACTION, or ACTION checked or unchecked
void expect_action(const Command& command) {
    const QString state = command.rest.section(' ', -1);
    const bool has_state = state == "checked" || state == "unchecked";
    QAction* action = require_action(has_state ? command.rest.section(' ', 0, -2) : command.rest);
    if (has_state && action->isChecked() != (state == "checked"))
        throw CommandError(QString("it is %1").arg(action->isChecked() ? "checked" : "unchecked"));
}

QTreeWidget* decoration_tree() {
    auto* tree = require_main_window()->findChild<QTreeWidget*>("decParsTree");
    if (!tree) throw CommandError("the layer dialog shows no decoration parameters");
    return tree;
}

void open_decoration_parameters(const Command&) {
    if (QTreeWidgetItem* first = decoration_tree()->topLevelItem(0)) first->setExpanded(true);
}

void expect_open_parameters(const Command&) {
    const QTreeWidgetItem* first = decoration_tree()->topLevelItem(0);
    if (!first || !first->isExpanded()) throw CommandError("they are not open");
}

// For commands that wait for a modal box.
CommandHandler in_modal(void (*act)(QWidget*, const Command&)) {
    return {[act](const Command& command) {
                QWidget* modal = QApplication::activeModalWidget();
                if (!modal) throw NotYet();
                act(modal, command);
            },
            Boxes::Subject};
}

void expect_modal(QWidget* modal, const Command& command) {
    if (!describe_box(modal).contains(QRegularExpression(command.rest)))
        throw CommandError("the box says: " + describe_box(modal));
}

/// The view on white, entry 2 of the backgrounds, counted from 0. Returns the file: MeshLab adds
/// two digits, the counter, to the base name.
QString fill_snapshot_box(QWidget* box, const QFileInfo& target, int tiles) {
    const struct {
        const char *name, *property;
        QVariant value;
    } fields[] = {{"outDirLineEdit", "text", target.absolutePath()},
                  {"baseNameLineEdit", "text", target.completeBaseName()},
                  {"counterSpinBox", "value", 0},
                  {"resolutionSpinBox", "value", tiles},
                  {"backgroundComboBox", "currentIndex", 2}};
    for (const auto& field : fields) {
        auto* child = box->findChild<QWidget*>(field.name);
        if (!child || !child->setProperty(field.property, field.value))
            throw CommandError(QString("the snapshot box has no field '%1'").arg(field.name));
    }
    return target.absolutePath() + "/" + target.completeBaseName() + "00.png";
}

// FILE TILES
void take_snapshot(const Command& command) {
    const QFileInfo target(command.word(0));
    QString written, error;
    QTimer::singleShot(0, require_main_window(), [&] {  // runs inside the box's event loop
        auto* box = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!box) return void(error = "MeshLab showed no snapshot box");
        try {
            written = fill_snapshot_box(box, target, int(command.number(1)));
            QFile::remove(written);
            box->accept();
        } catch (const CommandError& e) {
            error = e.what();
            box->reject();
        }
    });
    QMetaObject::invokeMethod(require_main_window(), "saveSnapshot", Qt::DirectConnection);
    // MeshLab draws tiles later, one per repaint. The time limit ends this otherwise.
    while (error.isEmpty() && !QFileInfo(written).size())
        QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 50);
    if (!error.isEmpty()) throw CommandError(error);
    QFile::remove(target.absoluteFilePath());
    if (!QFile::rename(written, target.absoluteFilePath()))
        throw CommandError("cannot write " + target.filePath());
}

}  // namespace

void add_dialog_commands(CommandTable& table) {
    table["trigger"] = {trigger};
    table["check"] = {check};
    table["expect-action"] = {expect_action};
    table["set"] = {[](const Command& c) { set_field(filter_dialog(), c); }};
    table["apply"] = {[](const Command&) { click_button(filter_dialog(), "Apply"); }};
    table["close"] = {[](const Command&) { click_button(filter_dialog(), "Close"); }};
    table["setdeco"] = {[](const Command& c) { set_field(decoration_tree(), c); }};
    table["open-parameters"] = {open_decoration_parameters};
    table["expect-open-parameters"] = {expect_open_parameters};
    table["expect-modal"] = in_modal(expect_modal);
    table["set-modal"] = in_modal(set_field);
    table["button"] =
        in_modal([](QWidget* modal, const Command& c) { click_button(modal, c.rest); });
    table["snapshot"] = {take_snapshot};
}

}  // namespace driver
