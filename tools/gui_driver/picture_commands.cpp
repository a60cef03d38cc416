// SPDX-License-Identifier: GPL-3.0-or-later
// The commands are described in README.md.
#include <QGuiApplication>
#include <QScreen>
#include "gui.h"
#include "modules.h"
#include "report.h"

namespace driver {
namespace {

void save(const QImage& picture, const QString& file_name) {
    if (picture.isNull() || !picture.save(file_name))
        throw CommandError(QString("cannot write the picture %1").arg(file_name));
    say(QString("%1: %2x%3")
            .arg(file_name)
            .arg(picture.width())
            .arg(picture.height())
            .toStdString());
}

// repaint, not updateGL: MeshLab draws in paintEvent, and updateGL only clears
void grabView(const Command& command) {
    QGLWidget* area = requireView();
    area->repaint();
    save(area->grabFrameBuffer(), command.rest);
}

void grabScreen(const Command& command) {
    if (QGLWidget* area = view()) area->repaint();
    save(QGuiApplication::primaryScreen()->grabWindow(0).toImage(), command.rest);
}

}  // namespace

void addPictureCommands(CommandTable& table) {
    table.addSimple("grab", grabView);
    table.addSimple("screen", grabScreen, Place::ModalBox);
}

}  // namespace driver
