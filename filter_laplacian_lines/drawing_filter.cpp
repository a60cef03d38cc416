// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "drawing_parameters.h"
#include "line_drawing/atomic_file.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet_file.h"
#include "meshlab_host/current_view.h"
#include "meshlab_host/documents.h"
#include "meshlab_host/layer_drawing.h"
#include "world_layers.h"

using laplacian_lines::part;
using line_drawing::Sheet;
using line_drawing::SheetOptions;

namespace {

const char* const kFilterName = "Export Laplacian Lines Drawing";

// Progress at the end of each step.
constexpr double kFieldShare = 0.05, kSheetShare = 0.98;

/// Name, scale and paper of the drawing, and the true size of the object; `size` in mm.
QString report(const WorldLayers& layers, const QString& file, const Sheet& sheet,
               const Eigen::Vector3d& size, const SheetOptions& options) {
    return QString(
               "Drawing of %1: %2, %3 on paper of %4 x %5 mm. %6 %7 in size, with %8 mm to the "
               "unit of the mesh.%9")
        .arg(names_of(layers), file,
             QString::fromStdString(sheet.scale > 0
                                        ? "scale " + line_drawing::scale_text(sheet.scale)
                                        : "in perspective and so without a scale"),
             QString::number(sheet.size.x()), QString::number(sheet.size.y()),
             QString(layers.size() > 1 ? "Together the objects are" : "The object is"),
             QString::fromStdString(line_drawing::size_text(size, " x ")),
             QString::number(options.mm_per_unit),
             sheet.kernel > 0
                 ? QString(" Inner lines have a kernel of √h = %1 mm on paper.")
                       .arg(QString::fromStdString(line_drawing::kernel_text(sheet.kernel)))
                 : QString());
}

/// Without hashes: a layer may differ from its file.
std::vector<line_drawing::SourceMesh> meshes_of(const WorldLayers& layers) {
    std::vector<line_drawing::SourceMesh> meshes;
    for (const WorldLayer& layer : layers)
        meshes.push_back({layer.name.toStdString(), {}});
    return meshes;
}

/// The name, with a number if that file is a drawing of other meshes, by their names, or one of the
/// command or of Python, which say more of their making.
QString free_name(const QString& name, const std::vector<line_drawing::SourceMesh>& meshes) {
    const QFileInfo info(name);
    QString result = name;
    for (int number = 2;; ++number) {
        QFile file(result);
        if (!QFileInfo(file).isFile()) return result;  // not there, or a pipe, which would block
        if (!file.open(QIODevice::ReadOnly) ||
            !line_drawing::is_of_other_meshes(file.readAll().toStdString(), meshes))
            return result;
        result = info.dir().filePath(
            QString("%1_%2.%3")
                .arg(info.completeBaseName(), QString::number(number), info.suffix()));
    }
}

void list_parameters(const MeshModel* mesh, RichParameterList& list) {
    const bool has_window = meshlab_host::current_view().has_value();
    list_drawing_parameters(drawing_defaults(mesh, has_window), list);
}

std::string in_system(const QString& name) {
    return QFile::encodeName(name).toStdString();
}

/// Source: the layers' names. In the title {name} becomes these, without endings.
void set_texts(const WorldLayers& layers, SheetOptions& options) {
    options.source = names_of(layers).toStdString();
    line_drawing::Words names;
    for (const WorldLayer& layer : layers)
        names.push_back(QFileInfo(layer.name).completeBaseName().toStdString());
    options.title = line_drawing::title_of(options.title, names);
}

/// Writes the file, under a free name; returns its whole path.
QString write(Sheet& sheet, const WorldLayers& layers, const QString& name) {
    const std::vector<line_drawing::SourceMesh> meshes = meshes_of(layers);
    sheet.provenance = line_drawing::provenance_text(meshes);
    const QString free = free_name(name, meshes);  // scripts run over a folder
    line_drawing::write_atomically(in_system(free), write_sheet(sheet, in_system(free)));
    return QFileInfo(free).absoluteFilePath();
}

void run(const meshlab_host::FilterRun& run) {
    const DrawingParameters chosen = read_drawing_parameters(run.parameters);
    const QString name = QString::fromStdString(file_for(*run.document.mm(), chosen.file));
    line_drawing::format_of(in_system(name));  // refuses now, not after the work
    line_drawing::check_writable(in_system(name));
    const std::optional<meshlab_host::CurrentView> window = meshlab_host::current_view();
    SheetOptions options = sheet_options(chosen, window);
    RichParameterList recorded;
    if (window)
        list_drawing_parameters(for_any_mesh(chosen, *run.document.mm(), *window), recorded);

    const WorldLayers layers = copy_layers(
        {chosen.is_of_all_layers, options.style.shows.needs_derivatives()}, run, kFieldShare);
    set_texts(layers, options);
    for (const std::string& remark : line_drawing::check_texts(options, in_system(name)))
        run.say(QString::fromStdString(remark));
    Sheet sheet = line_drawing::make_sheets(objects_of(layers), {options},
                                            part(run.progress, kFieldShare, kSheetShare))
                      .front();
    laplacian_lines::report(run.progress, 1, "Writing the drawing");
    const QString file = write(sheet, layers, name);

    const Eigen::Vector3d size =
        options.mm_per_unit * line_drawing::bounds_of(objects_of(layers)).sizes();
    run.say(report(layers, file, sheet, size, options));
    for (const std::string& remark : sheet.remarks)
        run.say(QString::fromStdString(remark));
    if (window) meshlab_host::record_as(kFilterName, recorded, run.document);
    run.results["file"] = file;
    run.results["scale"] = sheet.scale;
    meshlab_host::add_result("paper", {sheet.size.x(), sheet.size.y(), 0}, run.results);
    meshlab_host::add_result("object", size, run.results);
    meshlab_host::keep_unmodified(run.document);
}

}  // namespace

meshlab_host::Filter drawing_filter() {
    return {
        {kFilterName, "export_laplacian_lines_drawing",
         "Writes a measured drawing: lines at scale on paper, as vectors, from the window's view "
         "or several sides.",
         meshlab_host::FilterInterface::Normal},
        list_parameters,
        run};
}
