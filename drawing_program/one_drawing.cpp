// SPDX-License-Identifier: GPL-3.0-or-later
#include "one_drawing.h"

#include <QFileInfo>

#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"
#include "line_drawing/bounds.h"
#include "line_drawing/contact_sheet.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/sheet_file.h"
#include "line_drawing/whole_file.h"
#include "mesh_reading.h"
#include "say.h"

namespace {

using laplacian_lines::TriangleMesh;

/// Scans come in metres, too, and nothing in a file tells.
void saySize(const std::vector<TriangleMesh>& meshes, double unit) {
    Eigen::AlignedBox3d box;
    for (const TriangleMesh& mesh : meshes)
        box.extend(line_drawing::boundsOf(mesh));
    if (box.isEmpty()) return;
    const Eigen::Vector3d size = unit * box.sizes();
    const char* advice =
        size.maxCoeff() < 1 ? "if it is in metres, say --unit m" : "--unit says otherwise";
    say(stdout, QString("%1 %2 x %3 x %4 mm large, with %5 mm to the unit of the mesh; %6")
                    .arg(meshes.size() > 1 ? "together the objects are" : "the object is")
                    .arg(size.x())
                    .arg(size.y())
                    .arg(size.z())
                    .arg(unit)
                    .arg(advice));
}

/// Of damaged files the sheet says so, too.
std::vector<TriangleMesh> readMeshes(const CommandLine& commands,
                                     line_drawing::SheetOptions& options) {
    std::vector<TriangleMesh> meshes;
    QStringList sources;
    for (const QString& file : commands.meshes) {
        ReadMesh read = readMesh(file, commands.damaged);
        meshes.push_back(std::move(read.mesh));
        sources << QFileInfo(file).fileName();
        if (read.defect.isEmpty()) continue;
        say(stderr, QString("%1 is drawn incomplete: %2").arg(file, read.defect));
        sources.last().prepend("incomplete: ");  // notes may be cut off at their end
    }
    options.source = sources.join(", ");
    return meshes;
}

laplacian_lines::Field fieldOf(const TriangleMesh& mesh, const QString& file,
                               const laplacian_lines::LineStyle& style) {
    laplacian_lines::PrecomputeOptions options;
    options.curvature_derivatives = style.shows.needs_derivatives();
    try {
        return laplacian_lines::precompute(mesh, options);
    } catch (const laplacian_lines::Error& error) {
        throw laplacian_lines::Error(error.code(), file.toStdString() + ": " + error.what());
    }
}

}  // namespace

void drawOne(const CommandLine& commands) {
    line_drawing::checkSheetFile(commands.drawing);
    std::vector<line_drawing::SheetOptions> options = {commands.options};
    const std::vector<TriangleMesh> meshes = readMeshes(commands, options[0]);
    saySize(meshes, commands.options.mm_per_unit);
    const bool has_view = !commands.contact_view.isEmpty();
    if (has_view) options.push_back(line_drawing::contactOptions(meshes.front(), options[0]));
    std::vector<laplacian_lines::Field> fields;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        fields.push_back(fieldOf(meshes[i], commands.meshes[int(i)], commands.options.style));
    line_drawing::Objects objects;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        objects.push_back({meshes[i], fields[i]});
    const std::vector<line_drawing::Sheet> sheets = line_drawing::makeSheets(objects, options);
    line_drawing::writeSheet(sheets[0], commands.drawing, commands.dpi);
    for (const QString& remark : sheets[0].remarks)
        say(stderr, remark);
    if (has_view)
        line_drawing::writeWhole(commands.contact_view, line_drawing::packSheet(sheets[1]));
    say(stdout, "the drawing is " + commands.drawing);
}
