// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/provenance.h"

/// --like FILE: a drawing that is to be made again, with options that can be given here.
/// @throws laplacian_lines::Error(InvalidOption) if the file has none.
line_drawing::Provenance likeOf(const QString& file);

/// Says what is not as it was: the meshes, or this program.
void sayWhatDiffers(const line_drawing::Provenance& like,
                    const std::vector<line_drawing::Provenance::Mesh>& meshes);
