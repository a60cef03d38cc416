// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTimer>
#include <QTreeWidget>
#include "fields.h"
#include "gui.h"

namespace driver {
namespace {

void trigger(const Command& command) {
    QAction* action = requireAction(command.rest);
    if (!action->isEnabled()) throw CommandError("the action is disabled");
    action->trigger();
}

// ACTION on or off
void check(const Command& command) {
    const QString state = command.rest.section(' ', -1);
    QAction* action = requireAction(command.rest.section(' ', 0, -2));
    if (state != "on" && state != "off") throw CommandError("say on or off after the action");
    if (!action->isEnabled() || !action->isCheckable())
        throw CommandError("the action is disabled or not checkable");
    if (action->isChecked() != (state == "on")) action->trigger();
}

// ACTION, or ACTION checked or unchecked
void expectAction(const Command& command) {
    const QString state = command.rest.section(' ', -1);
    const bool has_state = state == "checked" || state == "unchecked";
    QAction* action = requireAction(has_state ? command.rest.section(' ', 0, -2) : command.rest);
    if (has_state && action->isChecked() != (state == "checked"))
        throw CommandError(QString("it is %1").arg(action->isChecked() ? "checked" : "unchecked"));
}

void setDecorationParameter(const Command& command) {
    auto* tree = requireMainWindow()->findChild<QTreeWidget*>("decParsTree");
    if (!tree) throw CommandError("the layer dialog shows no decoration parameters");
    setField(tree, command);
}

// For commands that wait for a modal box.
CommandTable::Handler inModal(void (*act)(QWidget*, const Command&)) {
    return [act](const Command& command) {
        QWidget* modal = QApplication::activeModalWidget();
        if (!modal) return Outcome::Retry;
        act(modal, command);
        return Outcome::Done;
    };
}

void expectModal(QWidget* modal, const Command& command) {
    if (!describeBox(modal).contains(QRegularExpression(command.rest)))
        throw CommandError("the box says: " + describeBox(modal));
}

template <class Widget>
Widget* childNamed(QWidget* box, const char* name) {
    if (auto* child = box->findChild<Widget*>(name)) return child;
    throw CommandError(QString("MeshLab's snapshot box has no field '%1'").arg(name));
}

/// Of one layer, on white. MeshLab adds two digits, the counter, to the base name.
QString fillSnapshotBox(QWidget* box, const QFileInfo& target, int tiles) {
    constexpr int white = 2;  // of current, transparent, white, black...
    childNamed<QLineEdit>(box, "outDirLineEdit")->setText(target.absolutePath());
    childNamed<QLineEdit>(box, "baseNameLineEdit")->setText(target.completeBaseName());
    childNamed<QSpinBox>(box, "counterSpinBox")->setValue(0);
    childNamed<QSpinBox>(box, "resolutionSpinBox")->setValue(tiles);
    childNamed<QComboBox>(box, "backgroundComboBox")->setCurrentIndex(white);
    return target.absolutePath() + "/" + target.completeBaseName() + "00.png";
}

// FILE TILES
void takeSnapshot(const Command& command) {
    const QFileInfo target(command.word(0));
    QString written, error;
    QTimer::singleShot(0, requireMainWindow(), [&] {  // runs inside the box's event loop
        auto* box = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!box) return void(error = "MeshLab showed no snapshot box");
        try {
            written = fillSnapshotBox(box, target, int(command.number(1)));
            QFile::remove(written);
            box->accept();
        } catch (const CommandError& e) {
            error = e.what();
            box->reject();
        }
    });
    QMetaObject::invokeMethod(requireMainWindow(), "saveSnapshot", Qt::DirectConnection);
    if (!error.isEmpty()) throw CommandError(error);
    // MeshLab draws tiles later, one per repaint. The time limit ends this otherwise.
    while (!QFileInfo(written).size())
        QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 50);
    QFile::remove(target.absoluteFilePath());
    if (!QFile::rename(written, target.absoluteFilePath()))
        throw CommandError("cannot write " + target.filePath());
}

}  // namespace

void addDialogCommands(CommandTable& table) {
    table.addSimple("trigger", trigger);
    table.addSimple("check", check);
    table.addSimple("expect-action", expectAction);
    table.addSimple("set", [](const Command& c) { setField(filterDialog(), c); });
    table.addSimple("apply", [](const Command&) { clickButton(filterDialog(), "Apply"); });
    table.addSimple("close", [](const Command&) { clickButton(filterDialog(), "Close"); });
    table.addSimple("setdeco", setDecorationParameter);
    table.add("expect-modal", inModal(expectModal), Boxes::Subject);
    table.add("set-modal", inModal(setField), Boxes::Subject);
    table.add("button",
              inModal([](QWidget* modal, const Command& c) { clickButton(modal, c.rest); }),
              Boxes::Subject);
    table.addSimple("snapshot", takeSnapshot);
}

}  // namespace driver
