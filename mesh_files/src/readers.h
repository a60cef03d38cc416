// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "polygons.h"

namespace mesh_files {

// Feed the builder, and say in a part of a sentence what they skip. @throws Defect where the bytes
// are malformed
std::string read_ply(std::string_view bytes, MeshBuilder& mesh);
std::string read_stl(std::string_view bytes, MeshBuilder& mesh);
std::string read_obj(std::string_view bytes, MeshBuilder& mesh);
std::string read_off(std::string_view bytes, MeshBuilder& mesh);

}  // namespace mesh_files
