// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "polygons.h"

namespace mesh_files {

// Feed the builder. @throws Defect where the bytes are malformed
void read_ply(std::string_view bytes, MeshBuilder& mesh);
void read_stl(std::string_view bytes, MeshBuilder& mesh);
void read_obj(std::string_view bytes, MeshBuilder& mesh);
void read_off(std::string_view bytes, MeshBuilder& mesh);

}  // namespace mesh_files
