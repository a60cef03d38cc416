// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include "drawing_watch.h"

#include <meshlab_host/geometry_stamp.h>

#include "command_table.h"
#include "gl_state_text.h"
#include "gui.h"

namespace driver {

using laplacian_lines::DrawnKernel;
using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;

namespace {

QString contextText() {
    return QString("context 0x%1\n").arg(quintptr(QGLContext::currentContext()), 0, 16);
}

/// Geometry and attribute names: drawing must change neither.
QString meshText(const MeshModel& mesh) {
    const meshlab_host::GeometryStamp stamp = meshlab_host::geometryStamp(mesh.cm);
    QString text = QString("%1 %2 %3").arg(stamp.vertices).arg(stamp.faces).arg(stamp.hash);
    for (const auto& attribute : mesh.cm.vert_attr)
        text += " " + QString::fromStdString(attribute._name);
    return text;
}

QString firstDifference(const QString& before, const QString& after) {
    const QStringList a = before.split('\n'), b = after.split('\n');
    for (int i = 0; i < qMax(a.size(), b.size()); ++i)
        if (a.value(i) != b.value(i))
            return QString("'%1' has become '%2'").arg(a.value(i), b.value(i));
    return {};
}

double length(const LineSet& lines) {
    double sum = 0;
    for (const auto& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
            sum += double((lines.points[i].position - lines.points[i - 1].position).norm());
    return sum;
}

bool same(const LinePoint& a, const LinePoint& b) {
    return a.position == b.position && a.weight == b.weight && a.opacity == b.opacity;
}

QString describe(const LineSet& lines) {
    return QString("%1 lines of %2 points, %3 long")
        .arg(lines.lines.size())
        .arg(lines.points.size())
        .arg(length(lines));
}

}  // namespace

DrawingWatch::DrawingWatch() {
    QObject* decoration = requireAction("Laplacian Lines")->parent();
    const bool connected = decoration &&
                           connect(decoration, SIGNAL(drawingBegins(MeshModel)), this,
                                   SLOT(drawingBegins(MeshModel)), Qt::DirectConnection) &&
                           connect(decoration,
                                   SIGNAL(drawingEnds(MeshModel, DecorationParameters,
                                                      std::vector<laplacian_lines::DrawnKernel>,
                                                      const laplacian_lines::LineSet*, QString)),
                                   this,
                                   SLOT(drawingEnds(MeshModel, DecorationParameters,
                                                    std::vector<laplacian_lines::DrawnKernel>,
                                                    const laplacian_lines::LineSet*, QString)),
                                   Qt::DirectConnection);
    if (!connected) throw CommandError("the decoration Laplacian Lines has no signals to watch");
}

QStringList DrawingWatch::takeProblems() {
    QStringList taken;
    taken.swap(problems_);
    return taken;
}

std::map<int, QString> DrawingWatch::takeDrawn() {
    std::map<int, QString> taken;
    taken.swap(drawn_);
    return taken;
}

QString DrawingWatch::summary() const {
    return QString("%1 drawings with %2 lines are the core's, %3 were refused with a reason")
        .arg(comparisons_)
        .arg(lines_)
        .arg(refusals_);
}

void DrawingWatch::drawingBegins(const MeshModel& mesh) {
    latest_problems_.clear();
    glGetError();  // somebody else's
    gl_state_ = contextText() + glStateText();
    mesh_state_ = meshText(mesh);
}

void DrawingWatch::drawingEnds(const MeshModel& mesh, const DecorationParameters& drawn,
                               const std::vector<DrawnKernel>& kernels, const LineSet* lines,
                               const QString& refusal) {
    kernels_ = kernels;
    drawn_[int(mesh.id())] = refusal.isEmpty() ? refusal : mesh.label() + ": " + refusal;
    const QString gl_change = firstDifference(gl_state_, contextText() + glStateText());
    if (!gl_change.isEmpty()) complain(mesh, "OpenGL's state: " + gl_change);
    const QString mesh_change = firstDifference(mesh_state_, meshText(mesh));
    if (!mesh_change.isEmpty()) complain(mesh, "drawing changed the mesh: " + mesh_change);
    if (lines)
        compare(mesh, drawn, kernels, *lines);
    else
        justify(mesh, drawn, refusal);
}

void DrawingWatch::compare(const MeshModel& mesh, const DecorationParameters& drawn,
                           const std::vector<DrawnKernel>& kernels, const LineSet& lines) {
    try {
        const LineSet& expected = core_.of(mesh, drawn, kernels);
        const bool equal =
            expected.lines.size() == lines.lines.size() &&
            expected.points.size() == lines.points.size() &&
            std::equal(expected.points.begin(), expected.points.end(), lines.points.begin(), same);
        if (!equal) complain(mesh, describe(lines) + " instead of " + describe(expected));
        ++comparisons_;
        lines_ += long(lines.lines.size());
    } catch (const std::exception& reason) {
        complain(mesh, describe(lines) + " instead of none: " + reason.what());
    }
}

void DrawingWatch::justify(const MeshModel& mesh, const DecorationParameters& drawn,
                           const QString& refusal) {
    ++refusals_;
    if (refusal.isEmpty()) complain(mesh, "no lines, and no reason is given");
    try {
        complain(mesh, "no lines: '" + refusal + "', but there are " +
                           describe(core_.of(mesh, drawn, {DrawnKernel()})));
    } catch (const std::exception&) {  // so it is right to refuse
    }
}

void DrawingWatch::complain(const MeshModel& mesh, const QString& what) {
    latest_problems_ << QString("layer %1, %2: %3").arg(mesh.id()).arg(mesh.label(), what);
    problems_ << latest_problems_.last();
}

}  // namespace driver
