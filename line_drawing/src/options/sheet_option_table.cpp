// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/option_rows.h"
#include "line_drawing/sheet_choices.h"
#include "line_drawing/sheet_file.h"

namespace line_drawing {
namespace {

namespace rows = laplacian_lines::option_rows;
using S = SheetChoices;
using Place = SheetOption::Place;
constexpr auto kLook = &S::look;

SheetOption text(std::string S::*member, const char* key, const char* label, const char* help,
                 const char* form, Place place = Place::Both, const char* command_word = nullptr,
                 bool is_repeatable = false) {
    return {rows::text(member, key, label, help), place, {}, form, command_word, is_repeatable};
}

template <class Table, class Row>
std::vector<const char*> column_of(const Table& table, const char* Row::*name) {
    std::vector<const char*> names;
    for (const Row& row : table)
        names.push_back(row.*name);
    return names;
}

SheetOption file() {
    static const std::string help =
        "Ends in " + list_of_endings(", ", " or ") + ". {folder}, {name}: the mesh's.";
    return {rows::file(&S::file, "file", "File", help.c_str(),
                       column_of(kSheetFormats, &SheetFormat::ending)),
            Place::Filter};
}

std::vector<SheetOption> make_table() {
    return {
        file(),
        text(&S::views, "views", "Views",
             "With commas: front, back, left, right, top, bottom, six (all of these), vessel "
             "(half section, half view), azimuth and elevation, as 30,15; in MeshLab also window.",
             "VIEWS"),
        text(&S::scale, "scale", "Scale",
             "Drawn to true length, such as 1:2 or 2:1; fit: the largest usual one that fits "
             "the paper.",
             "1:2|fit"),
        {rows::choice<&S::paper>(
            "paper", "Paper", paper_names(),
            "Upright or lying, whichever takes the drawing larger. fit: as large as the drawing.")},
        {rows::choice<&S::unit>(
            "unit", "Unit of the Mesh", column_of(kMeshUnits, &MeshUnit::name),
            "What a length of 1 is. The dialog begins with m below a size of 10, else mm.")},
        {rows::choice<kLook, &SheetLook::up>(
            "up", "Upward Axis", {"x", "y", "z"},
            "The axis of the world that points up in named views.")},
        text(&S::sections, "sections", "Sections",
             "What planes across the axes of the world cut: such as x=0.5 y=0.3, where 0 to 1 runs "
             "from one end of the object to the other. Empty: none.",
             "x|y|z=0..1", Place::Both, "section", true),
        text(&S::title, "title", "Title", "Above the notes. {name}: the mesh's.", "TEXT"),
        {rows::choice<&S::is_of_all_layers>(
             "layers", "Layers", {"Current Layer", "All Visible Layers"},
             "All Visible Layers: together, as they stand, hiding each other."),
         Place::Filter},
        {rows::choice<&S::settings>(
             "settings", "Settings", settings_names({"Defaults", "As the Decoration"}),
             "As the Decoration: lines and light as it has drawn them last in a window. The "
             "others: lines of these kinds, with the outlines."),
         Place::Filter},
        {rows::real<&S::detail>(
            "detail", "Detail", 0, 100,
            "0 to 100: fewer lines of all kinds, of coarser forms, or more of finer ones; 50 is "
            "the usual.")},
        {rows::choice<kLook, &SheetLook::arrangement>(
            "arrangement", "Arrangement", {"First Angle", "Third Angle"},
            "How views lie around the front view. First angle (Europe): what is seen from the left "
            "stands on the right; third angle (America): on the left.")},
        {rows::choice<kLook, &SheetLook::strokes>(
             "strokes", "Strokes", {"Tapered", "Plain"},
             "Lines that swell and taper as in MeshLab's view, or of even width, for plotters and "
             "CAD; those of DXF are always plain."),
         Place::Command},
        {rows::choice<kLook, &SheetLook::wall>(
            "wall", "Walls", {"Hatched", "Filled", "None"},
            "What sections cut: hatched, black, or its outline alone.")},
        {rows::choice<kLook, &SheetLook::hidden>(
            "hidden", "Hidden Lines", {"None", "Dashed"},
            "Outlines, borders and creases behind the surface.")},
        {rows::choice<&S::weights>(
            "weights", "Line Weights", {"Illustrator", "ISO 128"},
            "Illustrator: outlines are widest, edges within the form thin. ISO 128: edges that are "
            "seen are as wide as outlines, other lines half as wide.")},
        {rows::boolean<kLook, &SheetLook::has_annotations>(
             "annotations", "Scale Bar and Notes",
             "Names of views, scale bar, symbol of the projection, notes of scale, size and file."),
         Place::Both,
         {"none", "all"}},
        text(&S::kinds, "kinds", "Kinds of Lines",
             "With the outlines: usual (laplacian_lines, ridges, borders, creases), creases alone, "
             "as for machine parts, apparent_ridges and so on; a wrong one lists all.",
             "NAMES", Place::Command),
        text(&S::kernel, "kernel", "Kernel on Paper",
             "Detail of inner lines: a length on paper, or a share of the object's diagonal; "
             "auto: four pens of inner lines. Notes on the sheet have it as √h.",
             "auto|1mm|0.9%", Place::Command),
        text(&S::smoothing, "smoothing", "Smoothing on Paper",
             "Of the surface before lines are found, likewise.", "auto|0.3mm|0.2%", Place::Command),
        {rows::choice<kLook, &SheetLook::area>(
             "area", "Areas", {"None", "Filled", "Objects"},
             "What the outline of all, or of each object alone, encloses, as areas besides."),
         Place::Command},
        {rows::choice<kLook, &SheetLook::text>(
             "text", "Text", {"Letters", "Outlines"},
             "Letters of the reader's font, or their outlines, for print shops and plotters."),
         Place::Command},
        {rows::choice<&S::draws_damaged>(
             "damaged", "Damaged Files", {"Refuse", "Draw"},
             "Files that are not whole; what is drawn of them is called incomplete on the sheet."),
         Place::Command},
        {rows::real<&S::dpi>("dpi", "Dots per Inch", 20, 2400, "Of PNG files."), Place::Command},
        {rows::choice<&S::format>("format", "Format",
                                  column_of(kSheetFormats, &SheetFormat::ending),
                                  "Of the drawings in a folder."),
         Place::Command},
    };
}

}  // namespace

std::vector<const char*> settings_names(std::vector<const char*> own) {
    for (const laplacian_lines::LineMixture& mixture : laplacian_lines::kLineMixtures)
        own.push_back(mixture.label);
    return own;
}

const laplacian_lines::LineMixture* mixture_at(int settings) {
    if (settings <= kSettingsOfDecoration) return nullptr;
    return &laplacian_lines::kLineMixtures.at(std::size_t(settings - kSettingsOfDecoration - 1));
}

const std::vector<SheetOption>& sheet_option_table() {
    static const std::vector<SheetOption> table = make_table();
    return table;
}

}  // namespace line_drawing
