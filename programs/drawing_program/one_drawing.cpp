// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawings.h"

#include <QFileInfo>
#include <algorithm>

#include "command_line.h"
#include "file_names.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet_file.h"
#include "line_drawing/whole_file.h"
#include "mesh_reading.h"

namespace {

using line_drawing::SourceMesh;

/// Scans come in metres, too, and files do not tell.
void saySize(const std::vector<ReadMesh>& meshes, const CommandLine& commands) {
    Eigen::AlignedBox3d box;
    for (const ReadMesh& read : meshes)
        box.extend(line_drawing::boundsOf(read.mesh));
    if (box.isEmpty()) return;
    const double unit = commands.options.mm_per_unit;
    const Eigen::Vector3d size = unit * box.sizes();
    const char* advice = commands.words.contains("--unit") ? ""
                         : size.maxCoeff() < 1             ? "; if it is in metres, say --unit m"
                                                           : "; --unit says otherwise";
    say(stdout, QString("%1 %2 in size, with %3 mm to the unit of the mesh%4")
                    .arg(meshes.size() > 1 ? "together the objects are" : "the object is",
                         inQt(line_drawing::sizeInWords(size, " x ")))
                    .arg(unit)
                    .arg(advice));
}

std::vector<ReadMesh> readMeshes(const CommandLine& commands) {
    std::vector<ReadMesh> meshes;
    for (const QString& file : commands.meshes) {
        meshes.push_back(readMesh(file, commands.choices.draws_damaged));
        if (!meshes.back().remark.isEmpty())
            say(stderr, QString("%1: %2").arg(file, meshes.back().remark));
    }
    return meshes;
}

/// What is missing of an object, if anything.
QString lackOf(const ReadMesh& read) {
    if (!read.defect.isEmpty()) return read.defect;
    const auto& all = read.mesh.positions;
    const auto lacking = std::count_if(all.begin(), all.end(),
                                       [](const Eigen::Vector3d& p) { return !p.allFinite(); });
    if (lacking > 0)
        return QString("%1 of %2 vertices have no finite coordinates").arg(lacking).arg(all.size());
    return {};
}

/// File names, those not drawn whole marked by a word before: notes may be cut off at the end.
QString sourcesOf(const QStringList& files, const std::vector<ReadMesh>& meshes) {
    QStringList sources;
    for (int i = 0; i < files.size(); ++i) {
        sources << readable(QFileInfo(files[i]).fileName());
        const QString lack = lackOf(meshes[std::size_t(i)]);
        if (lack.isEmpty()) continue;
        say(stderr, QString("%1 is drawn incomplete: %2").arg(files[i], lack));
        sources.last().prepend("incomplete: ");
    }
    return sources.join(", ");
}

std::vector<SourceMesh> originsOf(const QStringList& files, const std::vector<ReadMesh>& meshes) {
    std::vector<SourceMesh> origins;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        origins.push_back(
            {readable(QFileInfo(files[int(i)]).fileName()).toStdString(), meshes[i].sha256.get()});
    return origins;
}

}  // namespace

void drawOne(const CommandLine& commands) {
    const std::string file = fileName(commands.drawing);
    const line_drawing::SheetFormat format = line_drawing::formatOf(file);
    line_drawing::checkWritable(file);
    const std::vector<ReadMesh> meshes = readMeshes(commands);
    const auto origins = [&] { return originsOf(commands.meshes, meshes); };
    if (commands.like) sayWhatDiffers(*commands.like, origins());
    saySize(meshes, commands);
    std::vector<line_drawing::SheetOptions> options = {commands.options};
    options[0].source = sourcesOf(commands.meshes, meshes).toStdString();
    const std::vector<std::string> remarks = line_drawing::checkTexts(options[0], format);
    const bool has_view = !commands.contact_view.isEmpty();
    if (has_view) options.push_back(line_drawing::contactOptions(meshes.front().mesh, options[0]));
    line_drawing::Objects objects;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        objects.push_back({meshes[i].mesh, nullptr, commands.meshes[int(i)].toStdString()});
    std::vector<line_drawing::Sheet> sheets = line_drawing::makeSheets(objects, options);
    sheets[0].provenance = line_drawing::provenanceText(origins(), inUtf8(commands.words));
    line_drawing::writeWhole(file, writeSheet(sheets[0], format, commands.choices.dpi));
    for (const auto& all : {remarks, sheets[0].remarks})
        for (const std::string& remark : all)
            say(stderr, inQt(remark));
    if (has_view)
        line_drawing::writeWhole(fileName(commands.contact_view),
                                 line_drawing::packSheet(sheets[1]));
    say(stdout, "the drawing is " + commands.drawing);
}
