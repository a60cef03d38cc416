// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/field_steps.h"

#include "system/large_array.h"

namespace laplacian_lines {

std::vector<Eigen::Vector3d> vertex_normals(const PreparedMesh& mesh, const VertexRanges& ranges,
                                            const StageProgress& stage) {
    auto normals = large_array<Eigen::Vector3d>(mesh.size(), Eigen::Vector3d::Zero());
    std::vector<std::uint32_t> any_triangle(mesh.size(), 0);
    // Of the incident area; less is rounding where faces cancel, as on the two sides of a card.
    constexpr double kLeastShare = 1e-4;
    ranges.for_each(stage, [&](const VertexRanges::Range& range) {
        range.prefetch(mesh.positions);
        range.for_each_triangle([&](const Triangle& t) {
            const Eigen::Vector3d area = area_vector(mesh, t);
            for (const std::uint32_t v : t) {
                if (!range.holds(v)) continue;
                normals[v] += area;
                any_triangle[v] = std::uint32_t(&t - mesh.triangles.data());
            }
        });
        for (std::uint32_t v = range.begin(); v < range.end(); ++v) {
            double length = normals[v].norm();
            if (!(length > kLeastShare * 6 * mesh.masses[v])) {  // twice the incident area
                // Faces that cancel leave no mean; any incident one will do.
                normals[v] = area_vector(mesh, mesh.triangles[any_triangle[v]]);
                length = normals[v].norm();
            }
            normals[v] /= length;
        }
    });
    return normals;
}

}  // namespace laplacian_lines
