// SPDX-License-Identifier: GPL-3.0-or-later
#include "one_drawing.h"

#include <QSaveFile>

#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"
#include "line_drawing/bounds.h"
#include "line_drawing/contact_sheet.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/sheet_file.h"
#include "mesh_reading.h"
#include "say.h"

namespace {

/// Scans come in metres, too, and nothing in a file tells.
void saySize(const laplacian_lines::TriangleMesh& mesh, double unit) {
    const Eigen::AlignedBox3d box = line_drawing::boundsOf(mesh);
    if (box.isEmpty()) return;
    const Eigen::Vector3d size = unit * box.sizes();
    const char* advice =
        size.maxCoeff() < 1 ? "if it is in metres, say --unit m" : "--unit says otherwise";
    say(stdout,
        QString("the object is %1 x %2 x %3 mm large, with %4 mm to the unit of the mesh; %5")
            .arg(size.x())
            .arg(size.y())
            .arg(size.z())
            .arg(unit)
            .arg(advice));
}

void writeView(const line_drawing::Sheet& sheet, const QString& file) {
    QSaveFile output(file);
    if (!output.open(QIODevice::WriteOnly) || output.write(line_drawing::packSheet(sheet)) < 0 ||
        !output.commit())
        throw laplacian_lines::Error(
            laplacian_lines::ErrorCode::InvalidOption,
            QString("\"%1\" cannot be written: %2").arg(file, output.errorString()).toStdString());
}

}  // namespace

void drawOne(const CommandLine& commands) {
    line_drawing::checkSheetFile(commands.drawing);
    const laplacian_lines::TriangleMesh mesh = readMesh(commands.meshes[0]);
    saySize(mesh, commands.options.mm_per_unit);
    std::vector<line_drawing::SheetOptions> options = {commands.options};
    const bool has_view = !commands.contact_view.isEmpty();
    if (has_view) options.push_back(line_drawing::contactOptions(mesh, commands.options));
    laplacian_lines::PrecomputeOptions field;
    field.curvature_derivatives = commands.options.style.shows.needs_derivatives();
    const std::vector<line_drawing::Sheet> sheets =
        line_drawing::makeSheets(mesh, laplacian_lines::precompute(mesh, field), options);
    line_drawing::writeSheet(sheets[0], commands.drawing, commands.dpi);
    if (has_view) writeView(sheets[1], commands.contact_view);
    say(stdout, "the drawing is " + commands.drawing);
}
