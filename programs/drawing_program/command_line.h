// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>

#include "line_drawing/sheet_choices.h"
#include "line_drawing/sheet_file.h"

/// What a drawing says of how it was made, see line_drawing::provenanceText().
struct Provenance {
    QString version;
    std::vector<line_drawing::SourceMesh> meshes;
    QStringList options;
};

/// --like FILE: an SVG, PDF or DXF file that is to be made again, with options that can be given
/// here.
/// @throws laplacian_lines::Error(InvalidOption) if the file has none.
Provenance likeOf(const QString& file);

/// Says what is not as it was: the meshes, or this program.
void sayWhatDiffers(const Provenance& like, const std::vector<line_drawing::SourceMesh>& meshes);

struct CommandLine {
    bool help = false, version = false;
    QString drawing;     ///< the file to write, or of a collection the folder to write into
    QStringList meshes;  ///< or folders of them; in a file, all are drawn together
    bool is_collection = false;
    QString format;        ///< of a collection
    QString contact_view;  ///< a file for the view of a contact sheet; empty: none
    /// Of the options as they were given, but for what only a collection has.
    QStringList words;
    std::optional<Provenance> like;  ///< what is to be drawn again
    line_drawing::SheetChoices choices;
    line_drawing::SheetOptions options;
};

/// @throws laplacian_lines::Error(InvalidOption)
CommandLine parseCommandLine(const QStringList& arguments);
QString usage();
