// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/sheet_file.h"

/// What a drawing says of how it was made, see line_drawing::provenanceText().
struct EarlierDrawing {
    std::string version;
    std::vector<line_drawing::SourceMesh> meshes;
    line_drawing::Words options;
};

/// Of an SVG, PDF or DXF file that is to be made again, with options that can be given here.
/// @throws laplacian_lines::Error(InvalidOption) if the file has none.
EarlierDrawing earlierDrawing(const std::string& file);

/// Says what is not as it was: the meshes, or this program.
void sayWhatDiffers(const EarlierDrawing& earlier,
                    const std::vector<line_drawing::SourceMesh>& meshes);
