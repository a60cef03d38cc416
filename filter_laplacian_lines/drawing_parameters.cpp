// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_parameters.h"

#include <QDir>
#include <QFileInfo>

#include "line_drawing/words.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/drawn_style.h"
#include "meshlab_host/parameters.h"

using laplacian_lines::refuse;
using line_drawing::SheetOption;
using line_drawing::SheetOptions;
using line_drawing::ViewFrame;
using meshlab_host::CurrentView;

namespace {

const std::vector<SheetOption>& filterOptions() {
    static const std::vector<SheetOption> options = [] {
        std::vector<SheetOption> of_filter;
        for (const SheetOption& option : line_drawing::sheetOptionTable())
            if (option.isOf(SheetOption::Place::Filter)) of_filter.push_back(option);
        return of_filter;
    }();
    return options;
}

/// In world coordinates.
double diagonalOf(const MeshModel& layer) {
    return meshlab_host::meanScale(meshlab_host::layerTransform(layer.cm)) *
           double(layer.cm.bbox.Diag());
}

const char* const window_view = "window";
const QString folder_place = "{folder}", name_place = "{name}";

QString folderOf(const MeshModel& mesh) {
    return QFileInfo(mesh.fullName()).absolutePath();
}
QString nameOf(const MeshModel& mesh) {
    return QFileInfo(mesh.fullName().isEmpty() ? mesh.label() : mesh.fullName()).completeBaseName();
}

ViewFrame frameOf(const CurrentView& window) {
    ViewFrame frame{line_drawing::Side::Other, "View", window.up.cross(window.towards_viewer),
                    window.up, window.towards_viewer};
    if (!window.is_orthographic) frame.eye = window.eye;
    return frame;
}

void takeFromDecoration(SheetOptions& options) {
    const meshlab_host::DrawnStyle drawn = meshlab_host::demandDrawnStyle();
    options.style = line_drawing::styleOnPaper(drawn.style);
    if (drawn.light_azimuth) options.light = meshlab_host::towardsLight(*drawn.light_azimuth);
}

}  // namespace

DrawingParameters drawingDefaults(const MeshModel* mesh, bool has_window) {
    DrawingParameters result;
    if (has_window) result.views = window_view;
    if (has_window && mesh) result.unit = likelyUnit(diagonalOf(*mesh));
    if (mesh && !mesh->fullName().isEmpty()) {
        const QFileInfo file(mesh->fullName());
        result.file = file.dir().filePath(file.completeBaseName() + "_drawing.svg").toStdString();
    }
    return result;
}

void listDrawingParameters(const DrawingParameters& defaults, RichParameterList& list) {
    for (const SheetOption& option : filterOptions())
        meshlab_host::addParameter(option.row, option.row.value(defaults), list);
}

DrawingParameters readDrawingParameters(const RichParameterList& list) {
    DrawingParameters result;
    for (const SheetOption& option : filterOptions())
        meshlab_host::readParameter(option.row, result, list);
    return result;
}

std::string fileFor(const MeshModel& mesh, const std::string& file) {
    return inQt(file)
        .replace(folder_place, folderOf(mesh))
        .replace(name_place, nameOf(mesh))
        .toStdString();
}

DrawingParameters forAnyMesh(DrawingParameters chosen, const MeshModel& mesh,
                             const CurrentView& window) {
    line_drawing::Words views = line_drawing::wordsOf(chosen.views);
    for (std::string& view : views)
        if (line_drawing::lower(view) == window_view) view = frameInWords(frameOf(window));
    chosen.views = line_drawing::joined(views, " ");
    const QFileInfo file(inQt(chosen.file));
    QString name = file.fileName();
    if (!mesh.fullName().isEmpty() && file.absolutePath() == folderOf(mesh)) {
        const int end = nameOf(mesh).size();
        const bool is_another = end < name.size() && name[end].isLetterOrNumber();
        if (name.startsWith(nameOf(mesh)) && !is_another) name.replace(0, end, name_place);
        chosen.file = (folder_place + '/' + name).toStdString();
    }
    return chosen;
}

SheetOptions sheetOptions(const DrawingParameters& chosen,
                          const std::optional<CurrentView>& window) {
    if (inQt(chosen.views).contains(window_view, Qt::CaseInsensitive) && !window)
        refuse(
            "There is no window whose view could be drawn. Name other \"Views\", such as front, "
            "six or 30,15.");
    line_drawing::NamedViews others;
    if (window) others[window_view] = frameOf(*window);
    SheetOptions options = line_drawing::sheetOptions(chosen, others);
    if (chosen.settings == line_drawing::settings_of_decoration) takeFromDecoration(options);
    if (const auto* mixture = line_drawing::mixtureAt(chosen.settings))
        options.style.shows = mixture->kinds;
    return options;
}
