// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/mesh_faults.h"

#include <cmath>
#include <sstream>

namespace laplacian_lines {
namespace {

// Limits were chosen on made faults, not fitted.

/// Shares of the edges; compact pieces of a hundred triangles have 15 % borders, of a thousand 5 %.
constexpr double kMostBorders = 0.2, kMostOpposed = 0.02;
/// Shares of the usable triangles that were turned: less is a few specks of a scan, more is nearly
/// all.
constexpr double kLeastFlipped = 1e-3, kMostFlipped = 0.9;

std::string percent(double share) {
    return std::to_string(std::lround(100 * share)) + " %";
}

}  // namespace

std::vector<MeshFault> faults_of(const MeshReport& report) {
    std::vector<MeshFault> faults;
    if (report.border_share > kMostBorders) faults.push_back(MeshFault::Torn);
    if (report.opposed_share > kMostOpposed) faults.push_back(MeshFault::Disagreeing);
    if (!faults.empty()) return faults;  // to be repaired first: others are judged on a surface
    const double turned =
        double(report.flipped_triangles) / double(report.triangles - report.degenerate_triangles);
    if (turned > kMostFlipped)
        faults.push_back(MeshFault::InsideOut);
    else if (turned > kLeastFlipped)
        faults.push_back(MeshFault::Flipped);
    if (report.coordinate_step > 0) faults.push_back(MeshFault::Quantized);
    return faults;
}

std::string describe(MeshFault fault, const MeshReport& report) {
    switch (fault) {
        case MeshFault::Torn:
            return percent(report.border_share) +
                   " of the edges are borders, so there is hardly a surface to draw: run MeshLab's "
                   "filter Merge Close Vertices.";
        case MeshFault::Disagreeing:
            return percent(report.opposed_share) +
                   " of the edges join triangles that face opposite ways, which cannot be made to "
                   "agree: run MeshLab's filter Re-Orient All Faces Coherently.";
        case MeshFault::InsideOut:
            return "The surface is inside out. It is drawn the right way round; MeshLab's filter "
                   "Invert Faces Orientation mends the mesh.";
        case MeshFault::Flipped:
            return std::to_string(report.flipped_triangles) + " of " +
                   std::to_string(report.triangles) +
                   " triangles face inwards, or unlike their neighbours. They are drawn the right "
                   "way round; MeshLab's filter Re-Orient All Faces Coherently mends the mesh.";
        case MeshFault::Quantized: {
            std::ostringstream message;
            message << "Coordinates are rounded to steps of " << report.coordinate_step
                    << ", a tenth of the triangles' edges or more, so smooth parts are drawn as "
                       "steps: export the mesh with more digits.";
            return message.str();
        }
    }
    return {};
}

}  // namespace laplacian_lines
