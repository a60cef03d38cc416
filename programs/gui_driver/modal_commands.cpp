// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTimer>
#include "command_table.h"
#include "fields.h"
#include "gui.h"

namespace driver {
namespace {

Outcome expectModal(const Command& command) {
    QWidget* modal = QApplication::activeModalWidget();
    if (!modal) return Outcome::Retry;
    if (!describeBox(modal).contains(QRegularExpression(command.rest)))
        throw CommandError("the box says: " + describeBox(modal));
    return Outcome::Done;
}

Outcome clickInModal(const Command& command) {
    QWidget* modal = QApplication::activeModalWidget();
    if (!modal) return Outcome::Retry;
    clickButton(modal, command.rest);
    return Outcome::Done;
}

Outcome setInModal(const Command& command) {
    QWidget* modal = QApplication::activeModalWidget();
    if (!modal) return Outcome::Retry;
    setFieldFromCommand(modal, command);
    return Outcome::Done;
}

template <class Widget>
Widget* childNamed(QWidget* box, const char* name) {
    auto* child = box->findChild<Widget*>(name);
    if (!child) throw CommandError(QString("MeshLab's snapshot box has no field '%1'").arg(name));
    return child;
}

// An entry of the box: current, transparent, white, black ...
int snapshotBackground(const QString& name) {
    if (name == "transparent") return 1;
    if (name == "white") return 2;
    throw CommandError("a snapshot's background is white or transparent, not " + name);
}

// MeshLab adds two digits, the counter, to the base name.
QString fillSnapshotBox(QWidget* box, const QFileInfo& target, int tiles, int background) {
    childNamed<QLineEdit>(box, "outDirLineEdit")->setText(target.absolutePath());
    childNamed<QLineEdit>(box, "baseNameLineEdit")->setText(target.completeBaseName());
    childNamed<QSpinBox>(box, "counterSpinBox")->setValue(0);
    childNamed<QSpinBox>(box, "resolutionSpinBox")->setValue(tiles);
    childNamed<QComboBox>(box, "backgroundComboBox")->setCurrentIndex(background);
    childNamed<QCheckBox>(box, "alllayersCheckBox")->setChecked(false);
    childNamed<QCheckBox>(box, "tiledSaveCheckBox")->setChecked(false);
    childNamed<QCheckBox>(box, "addToRastersCheckBox")->setChecked(false);
    return QString("%1/%2%3.png").arg(target.absolutePath(), target.completeBaseName(), "00");
}

void takeSnapshot(const Command& command) {
    const QFileInfo target(command.word(0));
    const int tiles = command.wordOr(1, "1").toInt();
    const int background = snapshotBackground(command.wordOr(2, "white"));
    QString written, error;
    QTimer::singleShot(0, requireMainWindow(), [&] {  // runs inside the box's event loop
        auto* box = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!box) return void(error = "MeshLab showed no snapshot box");
        try {
            written = fillSnapshotBox(box, target, tiles, background);
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

void addModalCommands(CommandTable& table) {
    table.add("expect-modal", expectModal, Place::ModalBox);
    table.add("set-modal", setInModal, Place::ModalBox);
    table.add("button", clickInModal, Place::ModalBox);
    table.addSimple("snapshot", takeSnapshot);
}

}  // namespace driver
