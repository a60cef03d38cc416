// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/sheet_file.h"

bool is_folder(const std::string& name);
bool is_named_like_mesh(const std::string& name);

/// The named meshes and those in named folders. @throws laplacian_lines::Error(InvalidOption) if a
/// folder has none
line_drawing::Words meshes_of(const line_drawing::Words& named);

/// Nothing if there is no such file, or it cannot be read to its end.
std::optional<std::string> contents_of(const std::string& file);

/// Any name, as UTF-8: names of files are bytes.
std::string readable(const std::string& name);

struct ReadMesh {
    std::string file;
    laplacian_lines::TriangleMesh mesh;
    line_drawing::SourceMesh source;
    std::string title;   ///< the file's name without ending
    std::string defect;  ///< of a damaged file: why the mesh is incomplete
    std::string remark;  ///< parts of a valid file that were skipped
};

/// Reads a PLY, OBJ, STL or OFF file, triangulated. A malformed file is refused, or drawn as far as
/// it goes. @throws laplacian_lines::Error(InvalidMesh) with a sentence that names the file
ReadMesh read_mesh(const std::string& file, bool draws_damaged);
