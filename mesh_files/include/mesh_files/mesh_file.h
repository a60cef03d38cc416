// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"

namespace mesh_files {

enum class Format { Ply, Stl, Obj, Off };

/// By extension, without the dot, in lower case.
std::optional<Format> format_of(std::string_view ending);
/// Those of all formats, likewise.
std::vector<std::string> endings();

struct MeshInFile {
    /// Vertices as in the file, in STL each facet's own. Polygons are triangulated inside.
    laplacian_lines::TriangleMesh mesh;
    /// Where and why the file is malformed: "line 12: a vertex has 2 of three coordinates". The
    /// mesh has at least the part before that, all if corners without finite coordinates are what
    /// is wrong. Empty: the file is valid.
    std::string defect;
    /// Parts of a valid file that were skipped: "faces skipped that have fewer than three corners:
    /// 2".
    std::string remark;
};

/// Reads any bytes, in time and memory proportional to their number; of vertices x, y and z only.
/// An OBJ file that was cut off between lines cannot be recognized. Thread-safe.
MeshInFile read_mesh(Format format, std::string_view bytes);

}  // namespace mesh_files
