// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

#include <string>
#include <vector>

#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/sheet_file.h"

namespace python_module {

/// Options of measured drawings that do not concern files, for laplacian_lines/options.py.
nanobind::list sheet_options();

/// Meshes drawn together, like files by the command.
struct DrawnMeshes {
    std::vector<laplacian_lines::TriangleMesh> meshes;
    std::vector<line_drawing::SourceMesh> sources;
};

struct Drawing {
    std::string content;
    double width, height, scale, kernel;  ///< as line_drawing::Sheet's
    std::vector<std::string> remarks;
};

/// Options are in the command's words; a name without a dot, "svg", is a format.
/// @throws laplacian_lines::Error
Drawing draw(const DrawnMeshes& drawn, const line_drawing::Words& words, const std::string& ending,
             const laplacian_lines::Progress& progress);

}  // namespace python_module
