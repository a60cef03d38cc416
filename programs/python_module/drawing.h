// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

#include <string>
#include <vector>

#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/provenance.h"

namespace python_module {

/// The options of measured drawings that are not about files, for laplacian_lines/options.py.
nanobind::list sheet_options();

/// What is drawn together, as the command draws files.
struct DrawnMeshes {
    std::vector<laplacian_lines::TriangleMesh> meshes;
    std::vector<line_drawing::SourceMesh> sources;
};

struct Drawing {
    std::string content;
    double width, height, scale, kernel;  ///< as line_drawing::Sheet's
    std::vector<std::string> remarks;
};

/// With options in the words of the command, and without a name with a dot: "svg".
/// @throws laplacian_lines::Error
Drawing draw(const DrawnMeshes& drawn, const line_drawing::Words& words, const std::string& ending,
             const laplacian_lines::Progress& progress);

}  // namespace python_module
