// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/view_frame.h"
#include "plane_lines.h"

namespace benchmarks {

struct PartMesh {
    double linear = 0, angular = 0;  ///< deflections, mm and rad
    laplacian_lines::TriangleMesh mesh;
};

/// Exact visible lines of a part from one direction, by OpenCASCADE.
struct ExactView {
    line_drawing::ViewFrame frame;
    PlaneLines demanded;  ///< have to be drawn
    PlaneLines allowed;   ///< tangent edges, which may be drawn
};

/// A CAD part. Its file is packed by zlib, behind the length of what is packed; numbers have the
/// lowest byte first, lists their length before them: "LLTRUTH1"; meshes: deflections, vertices as
/// three floats, triangles; views: name, a number to ignore, right, up and towards the viewer as
/// doubles, demanded and allowed lines, whose points are integers, steps from the last point in
/// 1/1000 mm.
struct CadPart {
    std::string name;
    std::vector<PartMesh> meshes;
    std::vector<ExactView> views;
};

/// @throws std::runtime_error with the file's name
CadPart read_part(const std::string& file);

}  // namespace benchmarks
