// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include "line_drawing/sheet_choices.h"
#include "line_drawing/sheet_file.h"
#include "line_drawing/words.h"

using line_drawing::Words;

/// The provenance of a drawing, see line_drawing::provenance_text().
struct EarlierDrawing {
    std::string version;
    std::vector<line_drawing::SourceMesh> meshes;
    Words options;
};

struct CommandLine {
    bool help = false, version = false;
    std::string drawing;  ///< the file to write, or of a collection the folder to write into
    Words meshes;         ///< files, drawn together, or each alone if they are a collection
    bool is_collection = false;
    Words words;  ///< options as given, with those of `like`, without those of collections
    std::optional<EarlierDrawing> like;  ///< the drawing to repeat
    line_drawing::SheetChoices choices;  ///< with the file, or for a collection its ending
    line_drawing::SheetOptions options;
};

/// @throws laplacian_lines::Error(InvalidOption)
CommandLine parse_command_line(Words arguments);
std::string usage();

/// Says what differs from the earlier drawing: the meshes, or this program.
void say_what_differs(const EarlierDrawing& earlier,
                      const std::vector<line_drawing::SourceMesh>& meshes);

/// A whole line at once, also from several threads.
void say(FILE* stream, const std::string& line);
