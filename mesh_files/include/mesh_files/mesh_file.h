// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace mesh_files {

enum class Format { Ply, Stl, Obj, Off };

/// By the ending of a file's name, without the dot, in small letters; none of others.
std::optional<Format> format_of(std::string_view ending);
/// The extensions of all formats.
std::vector<std::string> endings();

struct MeshInFile {
    /// Vertices as they are in the file, of STL three for each triangle. Polygons are triangles
    /// that stay inside them.
    laplacian_lines::TriangleMesh mesh;
    /// Where the file is not as its format has it, with the reason: "line 12: a vertex has two
    /// coordinates". The mesh has what comes before. Empty: the file is whole.
    std::string defect;
};

/// Reads a file's bytes, whatever they are, in time and memory in proportion to their number. Of
/// vertices only x, y and z are read. OBJ files do not say how much they hold: where lines are
/// missing at their end nobody can tell. Thread-safe.
MeshInFile read_mesh(Format format, std::string_view bytes);

}  // namespace mesh_files
