// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include "line_drawing/sheet_choices.h"
#include "line_drawing/sheet_file.h"
#include "line_drawing/words.h"

using line_drawing::Words;

/// What a drawing says of how it was made, see line_drawing::provenance_text().
struct EarlierDrawing {
    std::string version;
    std::vector<line_drawing::SourceMesh> meshes;
    line_drawing::Words options;
};

struct CommandLine {
    bool help = false, version = false;
    std::string drawing;  ///< the file to write, or of a collection the folder to write into
    Words meshes;         ///< files; in a file, all are drawn together
    bool is_collection = false;
    /// Of the options as they were given, but for what only a collection has.
    Words words;
    std::optional<EarlierDrawing> like;  ///< what is to be drawn again
    line_drawing::SheetChoices choices;  ///< with the file, or of a collection its ending alone
    line_drawing::SheetOptions options;
};

/// @throws laplacian_lines::Error(InvalidOption)
CommandLine parse_command_line(Words arguments);
std::string usage();

/// Says what is not as it was: the meshes, or this program.
void say_what_differs(const EarlierDrawing& earlier,
                      const std::vector<line_drawing::SourceMesh>& meshes);

/// A whole line at once, also from several threads.
void say(FILE* stream, const std::string& line);
