// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a designed mesh are as large as its form allows: a sum over the vertices is none
// over the surface. So:
//  1. Each corner of a triangle has a normal: the mean of those of the flat faces around its vertex
//     that are not beyond a sharp edge, by their areas and angles. Large faces are then flat up to
//     the fillets beside them.
//  2. Triangles are halved at their longest sides down to small ones. Each is a point of the sum,
//     with its area and the mean of the normals.
//  3. The vertices are put among these points, without a mass.
#include <Eigen/Geometry>
#include <array>

#include "field/field_steps.h"
#include "mesh/corner_normals.h"
#include "mesh/flat_faces.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

constexpr double kSpacing = 0.5;  // √h; sides of small triangles are shorter
// Of points, beside one for each vertex and one for each triangle: more take over a second.
constexpr std::size_t kMostPoints = 1000000;

/// The vertices of a mesh, and then points on its triangles.
struct PointCloud {
    std::vector<Vector3d> positions, normals;
    std::vector<double> masses;
    double spacing;    // local units
    std::size_t most;  // of all points, vertices included; with one more it is full

    bool is_full() const { return masses.size() > most; }

    /// Triangle p with the normals n at its corners, halved until sides are shorter than `spacing`.
    void add_triangle(const std::array<Vector3d, 3>& p, const std::array<Vector3d, 3>& n) {
        if (is_full()) return;
        std::size_t a = 0;  // where the longest side begins
        const auto length = [&](std::size_t k) { return (p[(k + 1) % 3] - p[k]).squaredNorm(); };
        for (std::size_t k = 1; k < 3; ++k)
            if (length(k) > length(a)) a = k;
        if (length(a) < spacing * spacing) {
            positions.push_back((p[0] + p[1] + p[2]) / 3);
            normals.push_back((n[0] + n[1] + n[2]).stableNormalized());
            masses.push_back((p[1] - p[0]).cross(p[2] - p[0]).norm() / 2);
            return;
        }
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        const Vector3d middle = (p[a] + p[b]) / 2, normal = (n[a] + n[b]) / 2;
        add_triangle({p[a], middle, p[c]}, {n[a], normal, n[c]});
        add_triangle({middle, p[b], p[c]}, {normal, n[b], n[c]});
    }
};

/// With a larger spacing if there are too many points.
PointCloud point_cloud(const PreparedMesh& mesh, const CornerNormals& corners,
                       const std::vector<CornerNormals::AtVertex>& vertices, double spacing) {
    const std::size_t most = mesh.size() + mesh.triangles.size() + kMostPoints;
    PointCloud cloud{mesh.positions, {}, std::vector<double>(mesh.size()), spacing, most};
    for (const CornerNormals::AtVertex& vertex : vertices)
        cloud.normals.push_back(vertex.normal);
    for (std::uint32_t t = 0; t < mesh.triangles.size() && !cloud.is_full(); ++t) {
        const auto [a, b, c] = mesh.triangles[t];
        cloud.add_triangle(
            {mesh.positions[a], mesh.positions[b], mesh.positions[c]},
            {corners.normal(3 * t), corners.normal(3 * t + 1), corners.normal(3 * t + 2)});
    }
    if (cloud.is_full()) return point_cloud(mesh, corners, vertices, 2 * spacing);
    return cloud;
}

}  // namespace

std::vector<Vector3d> designed_laplacian(const PreparedMesh& mesh, double kernel_size,
                                         const ShapeOperators& shape_operators,
                                         const PrecomputeOptions& options,
                                         const StageProgress& stage) {
    const CornerTable sides(mesh.triangles, mesh.size());
    const CornerNormals corners(mesh, sides, flat_faces(mesh, sides));
    const std::vector<CornerNormals::AtVertex> vertices = corners.at_vertices();
    PointCloud cloud = point_cloud(mesh, corners, vertices, kSpacing * kernel_size);
    PreparedMesh points;
    points.positions.swap(cloud.positions);
    points.original_vertex = numbers_up_to(points.size());
    const SpatialTree tree = sort_in_space(points);
    std::vector<Vector3d> normals_of_points(points.size());
    ShapeOperators operators(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t number = points.original_vertex[i];
        points.masses[i] = cloud.masses[number];
        normals_of_points[i] = cloud.normals[number];
        // they only correct borders: points are no targets, and sharp vertices have no tangent
        // plane
        if (number < mesh.size() && !vertices[number].is_sharp)
            operators[i] = shape_operators[number];
    }
    const std::vector<Vector3d> sums =
        belkin_laplacian(points, tree, normals_of_points, kernel_size, operators, options, stage);
    std::vector<Vector3d> laplacian(mesh.size(), Vector3d::Zero());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t v = points.original_vertex[i];
        if (v >= mesh.size() || vertices[v].normal.isZero()) continue;
        const Vector3d& n = vertices[v].normal;
        laplacian[v] = vertices[v].is_sharp ? Vector3d(n * n.dot(sums[i])) : sums[i];
    }
    return laplacian;
}

}  // namespace laplacian_lines
