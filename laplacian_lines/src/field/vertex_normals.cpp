// SPDX-License-Identifier: GPL-3.0-or-later
// The normal of a vertex is the mean of its triangles' normals, weighted by one of the rules that
// users may choose from; where they cancel, that of any of its triangles.
#include "field/field_steps.h"

#include <Eigen/Geometry>
#include <cmath>

#include "system/large_array.h"

namespace laplacian_lines {
namespace {

/// For the corner between the edge vectors u and v.
double corner_weight(NormalWeighting weighting, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
                     double twice_area) {
    switch (weighting) {
        case NormalWeighting::Angle:
            return std::atan2(twice_area, u.dot(v));
        case NormalWeighting::Max:
            return twice_area / (u.squaredNorm() * v.squaredNorm());
        case NormalWeighting::Area:
            break;
    }
    return twice_area;
}

}  // namespace

std::vector<Eigen::Vector3d> vertex_normals(const PreparedMesh& mesh, const VertexRanges& ranges,
                                            NormalWeighting weighting, const StageProgress& stage) {
    std::vector<Eigen::Vector3d> normals =
        large_array<Eigen::Vector3d>(mesh.size(), Eigen::Vector3d::Zero());
    std::vector<std::uint32_t> any_triangle(mesh.size(), 0);
    ranges.for_each(stage, [&](const VertexRanges::Range& range) {
        range.prefetch(mesh.positions);
        range.for_each_triangle([&](const Triangle& t) {
            const Eigen::Vector3d area = area_vector(mesh, t);
            const double twice_area = area.norm();
            const Eigen::Vector3d normal = area / twice_area;
            for (int k = 0; k < 3; ++k) {
                if (!range.holds(t[k])) continue;
                const Eigen::Vector3d& p = mesh.positions[t[k]];
                const Eigen::Vector3d u = mesh.positions[t[(k + 1) % 3]] - p;
                const Eigen::Vector3d v = mesh.positions[t[(k + 2) % 3]] - p;
                normals[t[k]] += corner_weight(weighting, u, v, twice_area) * normal;
                any_triangle[t[k]] = std::uint32_t(&t - mesh.triangles.data());
            }
        });
        for (std::uint32_t v = range.begin(); v < range.end(); ++v) {
            double length = normals[v].norm();
            if (!(length > 0 && std::isfinite(length))) {
                // Faces that cancel (a doubled sheet) leave no mean; any incident one will do.
                normals[v] = area_vector(mesh, mesh.triangles[any_triangle[v]]);
                length = normals[v].norm();
            }
            normals[v] /= length;
        }
    });
    return normals;
}

}  // namespace laplacian_lines
