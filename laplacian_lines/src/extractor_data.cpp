// SPDX-License-Identifier: GPL-3.0-or-later
#include "extractor_data.h"

#include <algorithm>
#include <cmath>

#include "laplacian_lines/error.h"
#include "prepared_mesh.h"
#include "spatial_tree.h"

namespace laplacian_lines {
namespace {

/// Renumbers triangles to the given vertex order and sorts them along it. The cyclic order of the
/// corners, and so the orientation, is kept.
std::vector<Triangle> reorder(const std::vector<Triangle>& triangles,
                              const std::vector<std::uint32_t>& order) {
    std::vector<std::uint32_t> position(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) position[order[i]] = i;
    std::vector<Triangle> result = triangles;
    for (Triangle& t : result) {
        for (std::uint32_t& v : t) v = position[v];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    }
    std::sort(result.begin(), result.end());
    return result;
}

void resize(ExtractorData& data, std::size_t n) {
    for (Vectors* vectors : {&data.positions, &data.normals, &data.laplacians}) vectors->resize(n);
    for (auto* scalars : {&data.normal_offsets, &data.laplacian_offsets, &data.slope_scale})
        scalars->resize(n);
    data.shape_operators.resize(n);
}

/// Copies vertex v of the field, whose local position is p, to place i.
void set_vertex(ExtractorData& data, std::size_t i, const Eigen::Vector3d& p, const Field& field,
                std::uint32_t v) {
    const double d = data.diagonal;
    const Eigen::Vector3d n = field.normals[v].cast<double>();
    const Eigen::Vector3d laplacian = field.laplacian_normals[v].cast<double>() * d * d;
    data.positions.set(i, p);
    data.normals.set(i, n);
    data.normal_offsets[i] = float(n.dot(p));
    data.laplacians.set(i, laplacian);
    data.laplacian_offsets[i] = float(laplacian.dot(p));
    const ShapeOperator& s = field.shape_operators[v];
    const float f = float(d);
    data.shape_operators[i] = {s.xx * f, s.yy * f, s.zz * f, s.yz * f, s.xz * f, s.xy * f};
    const double size = field.kernel_sizes[v] / d;
    // The smoothing of the normals follows the adaptive kernel, see PrecomputeOptions.
    const double sigma =
        field.scale.normal_sigma / d * (size / (field.scale.kernel_size / field.scale.diagonal));
    data.slope_scale[i] = float(std::pow(size * size + sigma * sigma / 2, 1.5));
}

template <class T>
std::size_t bytes(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

std::size_t bytes(const Vectors& v) { return bytes(v.x) + bytes(v.y) + bytes(v.z); }

}  // namespace

std::size_t ExtractorData::memory() const {
    return sizeof(*this) + bytes(positions) + bytes(normals) + bytes(normal_offsets) +
           bytes(laplacians) + bytes(laplacian_offsets) + bytes(shape_operators) +
           bytes(slope_scale) + bytes(triangles) + bytes(topology.edges) +
           bytes(topology.triangles_of_edge) + bytes(topology.edges_of_triangle);
}

ExtractorData build_extractor_data(const TriangleMesh& mesh, const Field& field) {
    const std::size_t n = mesh.positions.size();
    if (field.normals.size() != n || field.laplacian_normals.size() != n ||
        field.shape_operators.size() != n || field.kernel_sizes.size() != n)
        throw Error(ErrorCode::FieldMismatch,
                    "The Laplacian lines field belongs to another mesh; compute it again.");
    const PreparedMesh prepared = prepare_mesh(mesh);
    const SpatialTree tree(prepared.positions);
    ExtractorData data;
    data.centre = prepared.centre;
    data.diagonal = prepared.diagonal;
    resize(data, prepared.size());
    for (std::size_t i = 0; i < prepared.size(); ++i) {
        const std::uint32_t v = tree.order()[i];
        set_vertex(data, i, prepared.positions[v], field, prepared.original_vertex[v]);
    }
    data.triangles = reorder(prepared.triangles, tree.order());
    data.topology = build_edge_topology(prepared.size(), data.triangles);
    data.topology.triangles_of_edge = {};  // only borders need it
    return data;
}

}  // namespace laplacian_lines
