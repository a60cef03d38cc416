// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include <algorithm>

#include "command_table.h"
#include "gui.h"
#include "meshlab_host/documents.h"
#include "process.h"
#include "view_properties.h"

namespace driver {
namespace {

const QString kDecoration = "Laplacian Lines";

std::vector<const MeshModel*> layers() {
    const MeshDocument* document = shown_document();
    return document ? meshlab_host::layers_of(*document) : std::vector<const MeshModel*>();
}

/// What MeshLab says in boxes meanwhile, and whether its slot succeeds.
std::pair<QString, bool> invoke(const char* slot, const Command& command) {
    bool succeeds = false;
    take_answered_texts();
    QMetaObject::invokeMethod(require_main_window(), slot, Qt::DirectConnection,
                              Q_RETURN_ARG(bool, succeeds), Q_ARG(QString, command.rest));
    return {take_answered_texts().join("; "), succeeds};
}

[[noreturn]] void refuse(QString sentence, const QString& said) {
    if (!said.isEmpty()) sentence += ": " + said;
    throw CommandError(sentence);
}

/// MeshLab's message boxes are an error only if there is no mesh afterwards. ./run names the file.
void load(const Command& command) {
    const std::size_t before = layers().size();
    const auto [said, is_loaded] = invoke("importMeshWithLayerManagement", command);
    if (!is_loaded || layers().size() <= before) refuse("MeshLab cannot read it", said);
    if (!said.isEmpty()) say("remark: " + said.toStdString());
}

/// Fails on an incomplete project, with MeshLab's message.
void open_project(const Command& command) {
    const auto [said, is_opened] = invoke("openProject", command);
    if (!is_opened || !said.isEmpty() || layers().empty())
        refuse("MeshLab cannot open the project", said);
}

/// Why there are no lines, from the log; empty if it gives no reason.
QString refusal() {
    MeshDocument* document = shown_document();
    const MeshModel* layer = document ? document->mm() : nullptr;
    const QString beginning = kDecoration + ": " + (layer ? layer->label() + ": " : QString());
    const QString log = log_text();
    const int place = log.lastIndexOf(beginning);
    return place < 0 ? QString() : log.mid(place + beginning.size()).section('\n', 0, 0);
}

/// Prints warnings about meshes from the log, once.
void say_warnings() {
    static int told = 0;  // characters of the log that were read
    const QString log = log_text();
    for (const QString& line : log.mid(log.size() < told ? 0 : told).split('\n'))
        if (line.contains(": Warning: ")) say("warning: " + line.trimmed().toStdString());
    told = log.size();
}

QAction* switch_on() {
    QAction* action = require_action(kDecoration);
    if (!action->isChecked()) action->trigger();
    return action;
}

void draw_lines(const Command&) {
    const QAction* action = switch_on();
    say_warnings();
    if (action->isChecked()) return;
    const QString reason = refusal();
    throw CommandError(reason.isEmpty() ? "MeshLab does not draw the lines" : reason);
}

/// MeshLab switches decorations on layer by layer; the log tells which have no lines.
void draw_all_lines(const Command&) {
    for (const MeshModel* layer : layers()) {
        shown_document()->setCurrentMesh(layer->id());
        switch_on();
    }
}

/// Lines thinner than a pixel would have gaps: small views use a window's widths.
void scale_lines(const Command& command) {
    QGLWidget* area = require_view();
    const double scale = std::min(area->width(), area->height()) / command.number(0);
    area->setProperty(line_scale_property, std::max(scale, 1.0));
    area->update();
}

/// So that pictures do not depend on timing.
void wait_for_drawings(const Command&) {
    require_view()->setProperty(waits_property, true);
}

}  // namespace

void add_drawing_commands(CommandTable& table) {
    table["load"] = {load, Boxes::Answered};
    table["open-project"] = {open_project, Boxes::Answered};
    table["draw-lines"] = {draw_lines};
    table["draw-all-lines"] = {draw_all_lines};
    table["scale-lines"] = {scale_lines};
    table["wait-for-drawings"] = {wait_for_drawings};
}

}  // namespace driver
