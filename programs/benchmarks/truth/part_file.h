// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "laplacian_lines/triangle_mesh.h"
#include "plane_lines.h"

namespace benchmarks {

/// See directions.py.
enum class DirectionClass { Faces, Edges, Corners, AsideByAHair, AsideByADegree, Generic };
inline constexpr std::array direction_class_names = {"faces",      "edges",          "corners",
                                                     "1e-6 aside", "1 degree aside", "generic"};

struct PartMesh {
    double linear = 0, angular = 0;  ///< deflections, mm and rad
    laplacian_lines::TriangleMesh mesh;
};

/// Exact lines of a part from one direction.
struct ExactView {
    std::string name;
    DirectionClass direction_class = DirectionClass::Faces;
    PlaneFrame frame;
    PlaneLines demanded;  ///< have to be drawn
    PlaneLines allowed;   ///< tangent edges, which may be drawn
};

/// A CAD part as make_parts.py writes it.
struct CadPart {
    std::string name;
    std::vector<PartMesh> meshes;
    std::vector<ExactView> views;
};

/// @throws std::runtime_error with the file's name
CadPart read_part(const QString& file);

/// Parts and directions whose exact lines are wrong: a file of part, direction ("*": any) and
/// reason, separated by tabs; # begins a comment.
class LeftOut {
public:
    LeftOut() = default;
    /// @throws std::runtime_error with the line that is not understood
    explicit LeftOut(const QString& file);

    bool has(const std::string& part, const std::string& view) const {
        return entries_.count({part, view}) || entries_.count({part, "*"});
    }

private:
    std::set<std::pair<std::string, std::string>> entries_;
};

}  // namespace benchmarks
