// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/option_table.h"
#include "line_drawing/sheet_options.h"
#include "line_drawing/words.h"

namespace line_drawing {

/// What a person chooses for a drawing, as the command or the filter have it in writing.
struct SheetChoices {
    SheetLook look;
    std::string file = "drawing.svg";  ///< to be written
    std::string views = "front", sections, scale = "fit";
    std::string title;  ///< empty: none
    std::string kinds = "usual", kernel = "auto", smoothing = "auto";
    int paper = 1;  ///< of paperNames(), and one more: as large as the drawing
    int unit = 0;   ///< of mesh_units
    Weights weights = Weights::Illustrator;
    bool has_furniture = true;
    bool is_of_all_layers = false;  ///< the visible ones
    int settings = 0;               ///< see settingsNames()
    bool draws_damaged = false;     ///< files that are not whole
    double dpi = 300;               ///< of PNG
    int format = 0;                 ///< of drawings in a folder: pdf, svg, dxf, png
};

/// Units of meshes, by their number.
struct MeshUnit {
    const char* name;
    double mm;
};
inline constexpr MeshUnit mesh_units[] = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}};

/// The choice "Settings" of filters: what the filter itself says, what the decoration has drawn,
/// and then a mixture of kinds of lines each. Its numbers are what scripts hold.
constexpr int settings_of_decoration = 1;
std::vector<const char*> settingsNames(std::vector<const char*> own);
/// Null for the first two.
const laplacian_lines::LineMixture* mixtureAt(int settings);

/// An option of measured drawings. Its default is that of SheetChoices.
struct SheetOption {
    using Row = laplacian_lines::OptionDescription<SheetChoices>;
    enum class Place { Both, Command, Filter };

    Row row;
    Place place = Place::Both;
    std::string SheetChoices::*text = nullptr;  ///< of an option that is a text
    /// What the command calls it, without --; null: by its key.
    const char* command_word = nullptr;
    /// The command's words for a switch, off and on; those of choices are the first words of their
    /// labels, in lower case.
    std::vector<const char*> switch_words = {};
    /// How a text or a number is written, in the command's help.
    const char* form = "";
    bool adds_up = false;  ///< the command takes several

    bool isOf(Place one) const { return place == Place::Both || place == one; }
    std::string command() const;  ///< "--paper"
    Words words() const;          ///< of the command; none if anything may be written
    std::string valueIn(const SheetChoices& choices) const;  ///< as the command writes it
    /// Reads what the command was given.
    /// @throws laplacian_lines::Error(InvalidOption) that says what is allowed
    void read(const std::string& word, SheetChoices& choices) const;
};

/// All of them, in the order of the dialog. The command line, its help, the filter's parameters and
/// dialog are made from it; docs/ and examples are checked against it.
const std::vector<SheetOption>& sheetOptionTable();

/// The option that the command calls so, "--paper"; null: none.
const SheetOption* commandOption(const std::string& command);

/// Reads what the command was given: options, each with its value behind it. Views are those of the
/// sections where no others are named, and the usual ones where neither is.
/// @throws laplacian_lines::Error(InvalidOption)
SheetChoices readChoices(const Words& words);

/// A title with the names of meshes, without ending, in place of {name}.
std::string titleOf(std::string title, const Words& names);

/// The command's help: a few lines an option.
std::string sheetOptionsHelp();

/// What was written, read; `others` are views that a program knows besides.
/// @throws laplacian_lines::Error(InvalidOption) with what is understood
SheetOptions sheetOptions(const SheetChoices& choices, const NamedViews& others = {});

}  // namespace line_drawing
