// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "edge_topology.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// One array for each coordinate, so that a pass over all vertices is vectorized.
struct Vectors {
    std::vector<float> x, y, z;

    Eigen::Vector3f operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    void resize(std::size_t n) {
        x.resize(n);
        y.resize(n);
        z.resize(n);
    }
    void set(std::size_t i, const Eigen::Vector3d& v) {
        x[i] = float(v.x());
        y[i] = float(v.y());
        z[i] = float(v.z());
    }
};

/// What a redraw reads, in the order that it reads it: vertices in an order that keeps neighbours
/// together, triangles by their first vertex. Local coordinates x' = (x − centre)/D, so that all
/// thresholds are dimensionless as they stand.
struct ExtractorData {
    Vectors positions;                           ///< p, local
    Vectors normals;                             ///< n
    std::vector<float> normal_offsets;           ///< n·p
    Vectors laplacians;                          ///< Δn·D²
    std::vector<float> laplacian_offsets;        ///< Δn·p·D²
    std::vector<ShapeOperator> shape_operators;  ///< S·D
    std::vector<float> slope_scale;              ///< h_e(p)^1.5, local
    std::vector<Triangle> triangles;
    EdgeTopology topology;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the bounding box, mesh units
    double diagonal = 1;                               ///< D, mesh units

    std::size_t vertex_count() const { return normal_offsets.size(); }
    std::size_t memory() const;  ///< bytes
};

/// @throws Error: FieldMismatch, InvalidMesh, EmptyMesh.
ExtractorData build_extractor_data(const TriangleMesh& mesh, const Field& field);

}  // namespace laplacian_lines
