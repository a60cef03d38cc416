// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flat_faces.h"

#include <algorithm>
#include <numeric>

#include "mesh/triangles_at.h"
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
    explicit FlatTriangles(const PreparedMesh& mesh)
        : mesh_(mesh),
          at_(mesh.size(), mesh.triangles),
          normals_(mesh.triangles.size()),
          areas_(mesh.triangles.size()) {
        for_each_element(areas_.size(), [&](std::size_t i) {
            const Eigen::Vector3d area = area_vector(mesh, mesh.triangles[i]);
            areas_[i] = area.norm();
            normals_[i] = area.stableNormalized();
        });
    }

    /// Those for which is_counted(triangle), as a share of all.
    template <class IsCounted>
    double area_share(IsCounted is_counted) const {
        std::vector<double> counted(areas_.size(), 0);
        for_each_element(areas_.size(), [&](std::size_t i) {
            if (is_counted(std::uint32_t(i))) counted[i] = areas_[i];
        });
        return std::accumulate(counted.begin(), counted.end(), 0.0) / all();
    }

    double all() const { return std::accumulate(areas_.begin(), areas_.end(), 0.0); }
    double area(std::uint32_t triangle) const { return areas_[triangle]; }

    /// Until test(neighbour) is true of a neighbour in the triangle's plane, with two corners of
    /// it: looked for at the end of a side that has fewer triangles.
    template <class Test>
    bool any_beside(std::uint32_t triangle, Test test) const {
        const Triangle& t = mesh_.triangles[triangle];
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t from = t[k], to = t[(k + 1) % 3];
            if (at_.count(to) < at_.count(from)) std::swap(from, to);
            for (const std::uint32_t* other = at_.begin(from); other != at_.end(from); ++other) {
                const Triangle& o = mesh_.triangles[*other];
                if (*other != triangle && std::find(o.begin(), o.end(), to) != o.end() &&
                    normals_[*other].dot(normals_[triangle]) >= kFlat && test(*other))
                    return true;
            }
        }
        return false;
    }

private:
    const PreparedMesh& mesh_;
    const TrianglesAt at_;
    std::vector<Eigen::Vector3d> normals_;
    std::vector<double> areas_;
};

}  // namespace

bool is_made(const PreparedMesh& mesh) {
    const FlatTriangles flat(mesh);
    return flat.area_share([&](std::uint32_t i) {
        return flat.any_beside(i, [](std::uint32_t) { return true; });
    }) > kMadeShare;
}

bool has_large_faces(const PreparedMesh& mesh) {
    const FlatTriangles flat(mesh);
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
