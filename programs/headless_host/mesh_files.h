// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"

class MeshDocument;

namespace server {

/// Adds the meshes of a file or project as layers; the last becomes current. @throws MLException
void open(const Input& input, MeshDocument& document);

/// @throws MLException if there is no such layer or the file cannot be written
void save(const OutputMesh& output, MeshDocument& document);
void save(const OutputProject& output, MeshDocument& document);

}  // namespace server
