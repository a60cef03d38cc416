// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include <QColor>
#include <functional>

#include "camera.h"
#include "command_table.h"
#include "gl_state_text.h"
#include "gui.h"
#include "line_probe.h"
#include "meshlab_host/meshlab_api.h"
#include "process.h"

#include <laplacian_lines/option_table.h>

namespace driver {
namespace {

constexpr double reach = 2.0;         // pixels between a line and its ink
constexpr double least_found = 0.98;  // of the visible samples; lines may pass behind one another
constexpr double most_unexplained = 0.01;
constexpr int least_samples = 200;  // fewer would show nothing

QColor ink_colour = Qt::red;

template <class Options>
bool setOption(const std::vector<laplacian_lines::OptionDescription<Options>>& table,
               const QString& key, double value, Options& options) {
    for (const auto& row : table)
        if (key == row.key) {
            row.set(options, value);
            return true;
        }
    return false;
}

bool setLight(const QString& key, double value, Eigen::Vector3d& light) {
    const int axis = QStringList{"light_x", "light_y", "light_z"}.indexOf(key);
    if (axis >= 0) light[axis] = value;
    return axis >= 0;
}

// Set while a redraw is recorded, on the GUI thread.
using Recorder = std::function<void(const MeshModel&, const GLLogStream&)>;
Recorder record;
int recorded_layers = 0;
QString problem;

void redraw(QGLWidget* view, Recorder recorder) {
    recorded_layers = 0;
    problem.clear();
    record = std::move(recorder);
    view->repaint();
    record = nullptr;
    if (!problem.isEmpty()) throw CommandError(problem);
    if (recorded_layers == 0)
        throw CommandError("no layer has the decoration Laplacian Lines Probe switched on");
}

std::vector<ProjectedLines> recordRedraw(QGLWidget* view, const ProbeOptions& options) {
    std::vector<ProjectedLines> layers;
    redraw(view, [&](const MeshModel& mesh, const GLLogStream&) {
        layers.push_back(probeLayer(mesh, options));
    });
    return layers;
}

QString recordGlState(QGLWidget* view) {
    QString text;
    redraw(view, [&](const MeshModel&, const GLLogStream&) { text += glStateText(); });
    return text;
}

QString recordBoxes(QGLWidget* view) {
    QString text;
    redraw(view, [&](const MeshModel&, const GLLogStream& log) {
        text.clear();  // each layer sees the boxes of those before it
        const auto& boxes = log.realTimeLogMultiMap();
        for (auto box = boxes.begin(); box != boxes.end(); ++box)
            text += box.key() + ": " + box.value().second + "\n";
    });
    return text;
}

ProbeOptions parseOptions(const Command& command) {
    ProbeOptions options;
    for (const QString& word : command.words) {
        const QString key = word.section('=', 0, 0);
        bool is_number = false;
        const double value = word.section('=', 1).toDouble(&is_number);
        if (!is_number) throw CommandError("KEY=NUMBER is needed, not " + word);
        if (!setOption(laplacian_lines::precompute_option_table(), key, value, options.field) &&
            !setOption(laplacian_lines::line_style_table(), key, value, options.style) &&
            !setLight(key, value, options.light))
            throw CommandError("no option is called " + key);
    }
    return options;
}

struct Comparison {
    bool same = false;
    QString report;
};

Comparison compareView(const ProbeOptions& options) {
    QGLWidget* area = requireView();
    const std::vector<ProjectedLines> layers = recordRedraw(area, options);
    const ProbeResult result =
        compareWithPicture(layers, area->grabFrameBuffer(), ink_colour, reach);
    const QString report = QString(
                               "%1 layers; of %2 samples of visible lines %3 have ink; of %4 "
                               "inked pixels %5 are far from any line")
                               .arg(layers.size())
                               .arg(result.expected)
                               .arg(result.found)
                               .arg(result.inked)
                               .arg(result.unexplained);
    say(report.toStdString());
    if (result.expected < least_samples) throw CommandError("too few lines to compare: " + report);
    return {result.found >= least_found * result.expected &&
                result.unexplained <= most_unexplained * result.inked,
            report};
}

void expectLines(const Command& command) {
    const Comparison comparison = compareView(parseOptions(command));
    if (!comparison.same)
        throw CommandError("the view does not show the core's lines: " + comparison.report);
}

void expectOtherLines(const Command& command) {
    const Comparison comparison = compareView(parseOptions(command));
    if (comparison.same)
        throw CommandError("the view shows just these lines: " + comparison.report);
}

void expectNoLines(const Command&) {
    QGLWidget* area = requireView();
    area->repaint();
    const ProbeResult result = compareWithPicture({}, area->grabFrameBuffer(), ink_colour, reach);
    if (result.inked > 0)
        throw CommandError(QString("%1 pixels have the lines' colour").arg(result.inked));
}

void writeGlState(const Command& command) {
    writeFile(command.rest, recordGlState(requireView()).toUtf8());
}

// New cameras defeat whatever is kept for the next redraw.
void turn(const Command& command) {
    const int steps = int(command.number(0));
    const Orbit orbit;
    QString text;
    for (int step = 0; step < steps; ++step) {
        orbit.place(360.0 * step / steps, command.number(1));
        text += recordBoxes(requireView());
    }
    writeFile(command.word(2), text.toUtf8());
}

void chooseInk(const Command& command) {
    const QColor colour(command.word(0));
    if (!colour.isValid()) throw CommandError("no colour is called " + command.word(0));
    ink_colour = colour;
}

}  // namespace

void layerIsDrawn(const MeshModel& mesh, const GLLogStream& log) {
    if (!record) return;
    ++recorded_layers;
    try {
        record(mesh, log);
    } catch (const std::exception& e) {  // none may pass through MeshLab's drawing
        problem = e.what();
    }
}

void addProbeCommands(CommandTable& table) {
    table.addSimple("ink", chooseInk);
    table.addSimple("expect-lines", expectLines);
    table.addSimple("expect-other-lines", expectOtherLines);
    table.addSimple("gl-state", writeGlState);
    table.addSimple("turn", turn);
    table.addSimple("expect-no-lines", expectNoLines);
}

}  // namespace driver
