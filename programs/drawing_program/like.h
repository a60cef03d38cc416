// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>

#include "line_drawing/provenance.h"

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
