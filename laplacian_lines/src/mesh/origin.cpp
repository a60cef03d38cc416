// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mesh/corner_table.h"
#include "mesh/flat_faces.h"
#include "mesh/prepared_mesh.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// Share of the area in triangles with a side of more than 3 mean edges: segmented volumes have
// none, decimated to a quarter .26; CAD meshes that look like them .54 and more.
constexpr double kLongSide = 3, kMostUneven = 0.4;  // mean edges; share of the area
// Faces of voxels have 13 directions, of sides, edges and corners of a cube. These have .93 of the
// area, decimated to a quarter .64; of three CAD meshes with terraces .04, .05 and, of one that
// kMostUneven rejects, .71.
constexpr int kDirections = 13;
constexpr double kLeastOfVoxels = 0.5, kSameDirection = 0.9994;  // cosine of 2°
// Share of the area in triangles longer than the kernel, from which a mesh is a Design: seventy CAD
// parts have .71 and more, spheres and tori of even quadrilaterals none.
constexpr double kCoarseShare = 0.5;

/// The share of the area in triangles with a side of more than this length.
double share_of_long(const PreparedMesh& mesh, double length) {
    const auto area = [&](std::size_t t) { return area_vector(mesh, mesh.triangles[t]).norm(); };
    const auto is_long = [&](std::size_t t) {
        return longest_squared(mesh.positions, mesh.triangles[t]) > length * length;
    };
    const std::size_t count = mesh.triangles.size();
    return sum_of(count, [&](std::size_t t) { return is_long(t) ? area(t) : 0; }) /
           sum_of(count, area);
}

/// Whether flat faces are like those of voxels: small, and most of their area has as few
/// directions, whichever these are. Those of turned and decimated volumes are, too.
bool are_of_voxels(const FlatFaces& flat) {
    if (flat.are_large()) return false;
    auto rest =
        numbers_where(flat.face_of.size(), [&](std::uint32_t t) { return flat.face_of[t] == t; });
    std::sort(rest.begin(), rest.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(-flat.areas[a], a) < std::pair(-flat.areas[b], b);
    });
    const double all = std::accumulate(flat.areas.begin(), flat.areas.end(), 0.);
    double found = 0;
    for (int i = 0; i < kDirections && !rest.empty(); ++i) {
        const Eigen::Vector3d direction = flat.normals[rest[0]];
        const auto others = std::stable_partition(rest.begin(), rest.end(), [&](std::uint32_t f) {
            return std::abs(flat.normals[f].dot(direction)) > kSameDirection;
        });
        for (auto f = rest.begin(); f != others; ++f)
            found += flat.areas[*f];
        rest.erase(rest.begin(), others);
    }
    return found > kLeastOfVoxels * all;
}

}  // namespace

Origin origin_of(PreparedMesh& mesh) {
    const CornerTable& sides = sides_of(mesh);
    const FlatFaces flat = flat_faces(mesh, sides);
    if (!flat.is_cad_mesh()) return Origin::Scan;
    if (flat.share > kCadShare && share_of_long(mesh, kLongSide * mesh.mean_edge) < kMostUneven &&
        are_of_voxels(flat))
        return Origin::Voxels;
    return share_of_long(mesh, kDesignedKernel) > kCoarseShare ? Origin::Design
                                                               : Origin::FineDesign;
}

}  // namespace laplacian_lines
