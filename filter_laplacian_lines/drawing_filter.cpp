// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "drawing_parameters.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet_file.h"
#include "line_drawing/whole_file.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/documents.h"
#include "meshlab_host/layer_drawing.h"
#include "placed_layers.h"

using line_drawing::Sheet;
using line_drawing::SheetOptions;

namespace {

const char* const filter_name = "Export Laplacian Lines Drawing";

// Progress at the end of each step.
constexpr double field_share = 0.05, sheet_share = 0.98;

Eigen::Vector3d sizeOf(const PlacedLayers& layers) {
    Eigen::AlignedBox3d box;
    for (const PlacedLayer& layer : layers)
        box.extend(line_drawing::boundsOf(layer.mesh));
    return box.sizes();
}

/// Name, scale and paper of the drawing, and the assumed size of the object.
QString report(const PlacedLayers& layers, const QString& file, const Sheet& sheet,
               const Eigen::Vector3d& size, const SheetOptions& options) {
    return QString(
               "Drawing of %1: %2, %3 on paper of %4 x %5 mm. %6 %7 in size, with %8 mm to the "
               "unit of the mesh.%9")
        .arg(namesOf(layers), file,
             inQt(sheet.scale > 0 ? "scale " + line_drawing::scaleInWords(sheet.scale)
                                  : "in perspective and so without a scale"),
             QString::number(sheet.size.x()), QString::number(sheet.size.y()),
             QString(layers.size() > 1 ? "Together the objects are" : "The object is"),
             inQt(line_drawing::sizeInWords(size, " x ")), QString::number(options.mm_per_unit),
             sheet.kernel > 0 ? QString(" Inner lines have a kernel of √h = %1 mm on paper.")
                                    .arg(inQt(line_drawing::kernelInWords(sheet.kernel)))
                              : QString());
}

/// Without hashes: a layer may differ from its file.
std::vector<line_drawing::SourceMesh> meshesOf(const PlacedLayers& layers) {
    std::vector<line_drawing::SourceMesh> meshes;
    for (const PlacedLayer& layer : layers)
        meshes.push_back({layer.name.toStdString(), {}});
    return meshes;
}

/// Of a file that has no drawing of other meshes: with a number, if that named has one.
QString freeName(const QString& name, const std::vector<line_drawing::SourceMesh>& meshes) {
    const QFileInfo info(name);
    QString result = name;
    for (int number = 2;; ++number) {
        QFile file(result);
        if (!file.open(QIODevice::ReadOnly) ||
            !line_drawing::isOfOthers(file.readAll().toStdString(), meshes))
            return result;
        result = info.dir().filePath(
            QString("%1_%2.%3").arg(info.completeBaseName()).arg(number).arg(info.suffix()));
    }
}

void listParameters(const MeshModel* mesh, RichParameterList& list) {
    const bool has_window = meshlab_host::currentView().has_value();
    listDrawingParameters(drawingDefaults(mesh, has_window), list);
}

void run(const meshlab_host::FilterRun& run) {
    const DrawingParameters chosen = readDrawingParameters(run.parameters);
    QString name = inQt(fileFor(*run.document.mm(), chosen.file));
    std::string place = QFile::encodeName(name).toStdString();  // as the system has it
    line_drawing::formatOf(place);
    line_drawing::checkWritable(place);
    const std::optional<meshlab_host::CurrentView> window = meshlab_host::currentView();
    SheetOptions options = sheetOptions(chosen, window);
    RichParameterList recorded;
    if (window) listDrawingParameters(forAnyMesh(chosen, *run.document.mm(), *window), recorded);
    const PlacedLayers layers = placeLayers(
        {chosen.is_of_all_layers, options.style.shows.needs_derivatives()}, run, field_share);
    options.source = namesOf(layers).toStdString();
    line_drawing::Words names;
    for (const PlacedLayer& layer : layers)
        names.push_back(QFileInfo(layer.name).completeBaseName().toStdString());
    options.title = line_drawing::titleOf(options.title, names);
    for (const std::string& remark : line_drawing::checkTexts(options, place))
        run.say(inQt(remark));
    Sheet sheet =
        line_drawing::makeSheets(objectsOf(layers), {options},
                                 meshlab_host::progressTo(run.progress, field_share, sheet_share))
            .front();
    meshlab_host::beginStep(run.progress, 1, "Writing the drawing");
    const std::vector<line_drawing::SourceMesh> meshes = meshesOf(layers);
    sheet.provenance = line_drawing::provenanceText(meshes);
    name = freeName(name, meshes);  // scripts run over a folder
    place = QFile::encodeName(name).toStdString();
    line_drawing::writeWhole(place, writeSheet(sheet, place));
    const QString file = QFileInfo(name).absoluteFilePath();
    const Eigen::Vector3d size = options.mm_per_unit * sizeOf(layers);
    run.say(report(layers, file, sheet, size, options));
    for (const std::string& remark : sheet.remarks)
        run.say(inQt(remark));
    if (window) meshlab_host::recordAs(filter_name, recorded, run.document);
    run.results["file"] = file;
    run.results["scale"] = sheet.scale;
    meshlab_host::addResult("paper", {sheet.size.x(), sheet.size.y(), 0}, run.results);
    meshlab_host::addResult("object", size, run.results);
    meshlab_host::keepUnmodified(run.document);
}

}  // namespace

meshlab_host::Filter drawingFilter() {
    return {{filter_name, "export_laplacian_lines_drawing",
             QStringLiteral("Writes a measured drawing: lines at scale on paper, as vectors, from "
                            "the window's view or "
                            "several sides."),
             meshlab_host::FilterInterface::Normal, MeshModel::MM_FACENUMBER},
            listParameters,
            run};
}
