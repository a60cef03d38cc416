// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drawing_parameters.h"

/// What the dialog was last applied with, from one session of MeshLab to the next. File, title and
/// unit are the mesh's: another one only has the file's ending from it.

void keepSettings(const DrawingParameters& applied, const QString& mesh);

/// By fields of the dialog; `fresh` is what it has for this mesh by default. Nothing if nothing is
/// kept.
std::vector<DrawingField> keptSettings(const DrawingParameters& fresh, const QString& mesh);
