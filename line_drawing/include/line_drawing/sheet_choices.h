// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/option_table.h"
#include "line_drawing/sheet_options.h"
#include "line_drawing/words.h"

namespace line_drawing {

/// The options of a drawing as users write them for the command or the filter.
struct SheetChoices {
    SheetLook look;
    std::string file = "drawing.svg";  ///< to be written
    std::string views = "front", sections, scale = "fit";
    std::string title;  ///< empty: none
    std::string kinds = "usual", kernel = "auto", smoothing = "auto";
    int paper = 1;  ///< of paper_names()
    int unit = 0;   ///< of kMeshUnits
    Weights weights = Weights::Illustrator;
    bool is_of_all_layers = false;  ///< the visible ones
    int settings = 0;               ///< see settings_names()
    double detail = 50;             ///< as of LineStyle
    bool draws_damaged = false;     ///< also damaged files
    double dpi = 300;               ///< of PNG
    int format = 1;                 ///< of drawings in a folder: PDF of kSheetFormats
};

struct MeshUnit {
    const char* name;
    double mm;
};
inline constexpr MeshUnit kMeshUnits[] = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}};
constexpr int kMillimetre = 0, kMetre = 2;

/// The likely one of these for a mesh with this diagonal. Scanners write mm, and few objects are
/// smaller than 10 mm; photogrammetry and phones write m, and few are larger than 10 m. cm and
/// inches cannot be recognized.
constexpr int likely_unit(double diagonal) {
    return diagonal < 10 ? kMetre : kMillimetre;
}

/// The filters' choice "Settings": the filter's own and those of the decoration, named by `own`,
/// then one mixture of kinds each. Scripts hold the number.
constexpr int kSettingsOfDecoration = 1;
std::vector<const char*> settings_names(std::vector<const char*> own);
/// Null for the first two.
const laplacian_lines::LineMixture* mixture_at(int settings);

/// An option of measured drawings, with the default of SheetChoices.
struct SheetOption {
    using Row = laplacian_lines::OptionRow<SheetChoices>;
    enum class Place { Both, Command, Filter };

    Row row;
    Place place = Place::Both;
    /// The command's words for a switch, off and on. Choices go by the first words of their labels,
    /// in lower case.
    std::vector<const char*> switch_words = {};
    const char* form = "";  ///< placeholder for a text in the command's help
    /// The command's name for it, without --; null: the key.
    const char* command_word = nullptr;
    bool is_repeatable = false;  ///< may be given several times

    bool is_of(Place one) const { return place == Place::Both || place == one; }
    std::string command() const;  ///< "--paper"
    Words words() const;          ///< values that the command allows; none if any
    std::string value_in(const SheetChoices& choices) const;  ///< as the command writes it
    /// Reads the command's value. @throws laplacian_lines::Error(InvalidOption) that says what is
    /// allowed
    void read(const std::string& word, SheetChoices& choices) const;
};

/// In the order of the dialog. Command line, help, the filter's parameters and dialog are made from
/// it; the example of a script is checked against it.
const std::vector<SheetOption>& sheet_option_table();

/// By the command's name, such as "--paper"; null if there is none.
const SheetOption* command_option(const std::string& command);

/// Reads pairs of option and value. Without views, those of the sections, or else the usual ones.
/// @throws laplacian_lines::Error(InvalidOption)
SheetChoices read_choices(const Words& words);

/// Replaces {name} by these names of meshes, with commas between.
std::string title_of(std::string title, const Words& names);

/// The command's help.
std::string sheet_options_help();

/// Parses the choices; `others` are the program's own views.
/// @throws laplacian_lines::Error(InvalidOption) that says what is allowed
SheetOptions sheet_options(const SheetChoices& choices, const NamedViews& others = {});

}  // namespace line_drawing
