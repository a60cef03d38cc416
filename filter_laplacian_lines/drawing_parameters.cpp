// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_parameters.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "line_drawing/words.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/drawn_style.h"
#include "meshlab_host/parameters.h"
#include "window_frame.h"

using laplacian_lines::refuse;
using line_drawing::SheetOption;
using line_drawing::SheetOptions;
using meshlab_host::CurrentView;

namespace {

const std::vector<SheetOption>& filter_options() {
    static const std::vector<SheetOption> options = [] {
        std::vector<SheetOption> of_filter;
        for (const SheetOption& option : line_drawing::sheet_option_table())
            if (option.is_of(SheetOption::Place::Filter)) of_filter.push_back(option);
        return of_filter;
    }();
    return options;
}

/// In world coordinates.
double diagonal_of(const MeshModel& layer) {
    return laplacian_lines::mean_scale(meshlab_host::layer_transform(layer.cm)) *
           double(layer.cm.bbox.Diag());
}

const char* const kWindowView = "window";
const QString kFolderPlace = "{folder}", kNamePlace = "{name}";

QString folder_of(const MeshModel& mesh) {
    return mesh.fullName().isEmpty() ? QDir::currentPath()
                                     : QFileInfo(mesh.fullName()).absolutePath();
}
QString name_of(const MeshModel& mesh) {
    return QFileInfo(mesh.fullName().isEmpty() ? mesh.label() : mesh.fullName()).completeBaseName();
}

bool is_window(const std::string& view) {
    return line_drawing::lower(view) == kWindowView;
}

void take_from_decoration(SheetOptions& options) {
    const meshlab_host::DrawnStyle drawn = meshlab_host::require_drawn_style();
    options.style = line_drawing::style_on_paper(drawn.style);
    if (drawn.light_azimuth) options.light = meshlab_host::towards_light(*drawn.light_azimuth);
}

}  // namespace

DrawingParameters drawing_defaults(const MeshModel* mesh, bool has_window) {
    DrawingParameters result;
    if (has_window) result.views = kWindowView;
    if (has_window && mesh) result.unit = line_drawing::likely_unit(diagonal_of(*mesh));
    if (mesh && !mesh->fullName().isEmpty()) {
        const QFileInfo file(mesh->fullName());
        result.file = file.dir().filePath(file.completeBaseName() + "_drawing.svg").toStdString();
    }
    return result;
}

void list_drawing_parameters(const DrawingParameters& defaults, RichParameterList& list) {
    for (const SheetOption& option : filter_options())
        meshlab_host::add_parameter(option.row, option.row.value(defaults), list);
}

DrawingParameters read_drawing_parameters(const RichParameterList& list) {
    DrawingParameters result;
    for (const SheetOption& option : filter_options())
        meshlab_host::read_parameter(option.row, result, list);
    return result;
}

std::string file_for(const MeshModel& mesh, const std::string& file) {
    return QString::fromStdString(file)
        .replace(kFolderPlace, folder_of(mesh))
        .replace(kNamePlace, name_of(mesh))
        .toStdString();
}

DrawingParameters for_any_mesh(DrawingParameters chosen, const MeshModel& mesh,
                               const CurrentView& window) {
    line_drawing::Words views = line_drawing::words_of(chosen.views);
    for (std::string& view : views)
        if (is_window(view)) view = frame_text(frame_of(window));
    chosen.views = line_drawing::joined(views, " ");
    const QFileInfo file(QString::fromStdString(chosen.file));
    QString name = file.fileName();
    if (!mesh.fullName().isEmpty() && file.absolutePath() == folder_of(mesh)) {
        const int end = name_of(mesh).size();
        const bool is_another = end < name.size() && name[end].isLetterOrNumber();
        if (name.startsWith(name_of(mesh)) && !is_another) name.replace(0, end, kNamePlace);
        chosen.file = (kFolderPlace + '/' + name).toStdString();
    }
    return chosen;
}

SheetOptions sheet_options(const DrawingParameters& chosen,
                           const std::optional<CurrentView>& window) {
    const line_drawing::Words views = line_drawing::words_of(chosen.views);
    if (!window && std::any_of(views.begin(), views.end(), is_window))
        refuse(
            "There is no window whose view could be drawn. Name other \"Views\", such as front, "
            "six or 30,15.");
    line_drawing::NamedViews others;
    if (window) others[kWindowView] = frame_of(*window);
    SheetOptions options = line_drawing::sheet_options(chosen, others);
    if (chosen.settings == line_drawing::kSettingsOfDecoration) take_from_decoration(options);
    if (const auto* mixture = line_drawing::mixture_at(chosen.settings))
        options.style.shows = mixture->kinds;
    return options;
}
