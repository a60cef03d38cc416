// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_sheet.h"

#include "laplacian_lines/error.h"
#include "line_drawing/sheet_file.h"
#include "mesh_unit.h"
#include "meshlab_host/drawn_style.h"
#include "settings_choice.h"
#include "view_words.h"

using line_drawing::SheetOptions;
using line_drawing::ViewFrame;
using meshlab_host::CurrentView;

namespace {

[[noreturn]] void refuse(const char* sentence) {
    throw laplacian_lines::Error(laplacian_lines::ErrorCode::InvalidOption, sentence);
}

ViewFrame frameOf(const CurrentView& window) {
    ViewFrame frame{line_drawing::Side::Other, "View", window.up.cross(window.towards_viewer),
                    window.up, window.towards_viewer};
    if (!window.is_orthographic) frame.eye = window.eye;
    return frame;
}

std::vector<ViewFrame> viewsOf(const DrawingParameters& chosen,
                               const std::optional<CurrentView>& window) {
    if (chosen.views.contains(window_view, Qt::CaseInsensitive) && !window)
        refuse(
            "There is no window whose view could be drawn. Name other \"Views\", such as front, "
            "six or 30,15.");
    line_drawing::NamedViews others;
    if (window) others[window_view] = frameOf(*window);
    return line_drawing::parseViews(chosen.views, chosen.up, others);
}

void takeFromDecoration(SheetOptions& options) {
    const std::optional<meshlab_host::DrawnStyle> drawn = meshlab_host::drawnStyle();
    if (!drawn)
        refuse(
            "The decoration Laplacian Lines has drawn nothing here. Switch it on in MeshLab's "
            "window first, or set \"Settings\" to 0 (Defaults).");
    options.style = line_drawing::styleOnPaper(drawn->style);
    if (drawn->light) options.light = meshlab_host::towardsLight(*drawn->light);
}

}  // namespace

SheetOptions sheetOptions(const DrawingParameters& chosen,
                          const std::optional<CurrentView>& window) {
    SheetOptions options;
    options.up = chosen.up;
    options.sections = line_drawing::parseSections(chosen.sections);
    if (!chosen.views.trimmed().isEmpty() || options.sections.empty())
        options.views = viewsOf(chosen, window);
    options.scale = line_drawing::parseScale(chosen.scale);
    const std::vector<const char*> papers = line_drawing::paperNames();
    const auto paper = std::size_t(chosen.paper);
    options.paper = paper < papers.size() ? papers[paper] : "fit";
    options.mm_per_unit = mesh_units[chosen.unit].mm;
    options.arrangement = chosen.arrangement;
    options.strokes = line_drawing::strokesIn(chosen.file, chosen.strokes);
    options.wall = chosen.wall;
    options.hidden = chosen.hidden;
    options.pens = line_drawing::pensOf(chosen.weights);
    options.title = chosen.title;
    options.has_view_names = options.has_scale_bar = options.has_notes = chosen.has_furniture;
    if (chosen.settings == settings_of_decoration) takeFromDecoration(options);
    if (const auto* mixture = mixtureAt(chosen.settings)) options.style.shows = mixture->kinds;
    return options;
}
