// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flat_faces.h"

#include "system/disjoint_sets.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr double kFlat = 0.9999984769132877;  // least cosine: of 0.1°
// Of the area. Labels of a head and of an ellipsoid, 40 to 100 voxels, have up to 0.16 of theirs in
// such faces, but 0.54 if they are as flat as a lens; housings and plates have from 0.40 on.
constexpr double kLargeFace = 0.02, kShareOfLarge = 0.33;

class FlatTriangles {
public:
    FlatTriangles(const PreparedMesh& mesh, const CornerTable& sides)
        : table_(sides), normals_(mesh.triangles.size()), areas_(mesh.triangles.size()) {
        for_each_element(areas_.size(), [&](std::size_t i) {
            const Eigen::Vector3d area = area_vector(mesh, mesh.triangles[i]);
            areas_[i] = area.norm();
            normals_[i] = area.stableNormalized();
        });
    }

    /// Those for which is_counted(triangle), as a share of all.
    template <class IsCounted>
    double area_share(IsCounted is_counted) const {
        return sum_of(areas_.size(),
                      [&](std::size_t i) { return is_counted(std::uint32_t(i)) ? areas_[i] : 0; }) /
               all();
    }

    double all() const {
        return sum_of(areas_.size(), [&](std::size_t i) { return areas_[i]; });
    }
    double area(std::uint32_t triangle) const { return areas_[triangle]; }

    /// Until test(neighbour) is true of a neighbour in the triangle's plane.
    template <class Test>
    bool any_beside(std::uint32_t triangle, Test test) const {
        for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
            if (!table_.has_neighbour(side)) continue;
            const std::uint32_t other = table_.across(side) / 3;
            if (normals_[other].dot(normals_[triangle]) >= kFlat && test(other)) return true;
        }
        return false;
    }

private:
    const CornerTable& table_;
    std::vector<Eigen::Vector3d> normals_;
    std::vector<double> areas_;
};

}  // namespace

double flat_share(const PreparedMesh& mesh, const CornerTable& sides) {
    const FlatTriangles flat(mesh, sides);
    return flat.area_share(
        [&](std::uint32_t i) { return flat.any_beside(i, [](std::uint32_t) { return true; }); });
}

bool has_large_faces(const PreparedMesh& mesh, const CornerTable& sides) {
    const FlatTriangles flat(mesh, sides);
    DisjointSets faces(mesh.triangles.size());
    for (std::uint32_t i = 0; i < faces.size(); ++i)
        flat.any_beside(i, [&](std::uint32_t other) {
            faces.unite(i, other);
            return false;
        });
    const std::vector<std::uint32_t> face_of = faces.take_roots();
    std::vector<double> areas(face_of.size(), 0);
    for (std::uint32_t i = 0; i < face_of.size(); ++i)
        areas[face_of[i]] += flat.area(i);
    const double least = kLargeFace * flat.all();
    return flat.area_share([&](std::uint32_t i) { return areas[face_of[i]] >= least; }) >
           kShareOfLarge;
}

}  // namespace laplacian_lines
