// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "edge_topology.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// A linear form in the homogeneous eye (e, w) at each vertex: v·(e − w p), stored as v and v·p.
/// One array for each number, so that a pass over all vertices is vectorized.
struct LinearForms {
    std::vector<float> x, y, z, offset;

    void resize(std::size_t n) {
        for (auto* values : {&x, &y, &z, &offset})
            values->resize(n);
    }
    void set(std::size_t i, const Eigen::Vector3d& v, const Eigen::Vector3d& p) {
        x[i] = float(v.x());
        y[i] = float(v.y());
        z[i] = float(v.z());
        offset[i] = float(v.dot(p));
    }
};

/// What only the vertices near a line are asked for; together, since they are far apart.
struct VertexRecord {
    Eigen::Vector3f position;      ///< p, local
    ShapeOperator shape_operator;  ///< S·D
    float slope_scale;             ///< h_e(p)^1.5, local
};

/// What a redraw reads, in the order that it reads it: vertices in an order that keeps neighbours
/// together, triangles by their first vertex. Local coordinates x' = (x − centre)/D, so that all
/// thresholds are dimensionless as they stand.
struct ExtractorData {
    LinearForms normals;     ///< n·l, the illumination
    LinearForms laplacians;  ///< Δn·l·D², its Laplacian in the paper's form
    std::vector<VertexRecord> vertices;
    std::vector<Triangle> triangles;
    EdgeTopology topology;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the bounding box, mesh units
    double diagonal = 1;                               ///< D, mesh units

    std::size_t memory() const;  ///< bytes
};

/// @throws Error: FieldMismatch, InvalidMesh, EmptyMesh.
ExtractorData build_extractor_data(const TriangleMesh& mesh, const Field& field);

}  // namespace laplacian_lines
