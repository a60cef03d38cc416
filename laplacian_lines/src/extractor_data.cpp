// SPDX-License-Identifier: GPL-3.0-or-later
#include "extractor_data.h"

#include <cmath>

#include "laplacian_lines/error.h"
#include "prepared_mesh.h"

namespace laplacian_lines {
namespace {

/// Copies vertex v of the field, whose local position is p, to place i.
void set_vertex(ExtractorData& data, std::size_t i, const Eigen::Vector3d& p, const Field& field,
                std::uint32_t v) {
    const double d = data.diagonal;
    const Eigen::Vector3d n = field.normals[v].cast<double>();
    const Eigen::Vector3d laplacian = field.laplacian_normals[v].cast<double>() * d * d;
    data.normals.set(i, n, p);
    data.laplacians.set(i, laplacian, p);
    const ShapeOperator& s = field.shape_operators[v];
    const float f = float(d);
    const double size = field.kernel_sizes[v] / d;
    // The smoothing of the normals follows the adaptive kernel, see PrecomputeOptions.
    const double sigma =
        field.scale.normal_sigma / d * (size / (field.scale.kernel_size / field.scale.diagonal));
    data.vertices[i] = {p.cast<float>(),
                        {s.xx * f, s.yy * f, s.zz * f, s.yz * f, s.xz * f, s.xy * f},
                        float(std::pow(size * size + sigma * sigma / 2, 1.5))};
}

template <class T>
std::size_t bytes(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

std::size_t bytes(const LinearForms& f) {
    return bytes(f.x) + bytes(f.y) + bytes(f.z) + bytes(f.offset);
}

}  // namespace

std::size_t ExtractorData::memory() const {
    return sizeof(*this) + bytes(normals) + bytes(laplacians) + bytes(vertices) + bytes(triangles) +
           bytes(topology.edges_of_triangle);
}

ExtractorData build_extractor_data(const TriangleMesh& mesh, const Field& field) {
    const std::size_t n = mesh.positions.size();
    if (field.normals.size() != n || field.laplacian_normals.size() != n ||
        field.shape_operators.size() != n || field.kernel_sizes.size() != n)
        throw Error(ErrorCode::FieldMismatch,
                    "The Laplacian lines field belongs to another mesh; compute it again.");
    PreparedMesh prepared = prepare_mesh(mesh);
    sort_in_space(prepared);
    ExtractorData data;
    data.centre = prepared.centre;
    data.diagonal = prepared.diagonal;
    data.normals.resize(prepared.size());
    data.laplacians.resize(prepared.size());
    data.vertices.resize(prepared.size());
    for (std::size_t i = 0; i < prepared.size(); ++i)
        set_vertex(data, i, prepared.positions[i], field, prepared.original_vertex[i]);
    data.triangles = std::move(prepared.triangles);
    data.topology = build_edge_topology(prepared.size(), data.triangles);
    return data;
}

}  // namespace laplacian_lines
