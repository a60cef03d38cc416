// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cluster_partition.h"
#include "extractor_data.h"

namespace laplacian_lines {

/// Values of a vertex as clusters hold them, local.
struct LocalVertex {
    Eigen::Vector3d position, normal, laplacian;  ///< laplacian: Δn·D²
    ShapeOperator shape_operator;                 ///< S·D
    float slope_scale;                            ///< h_e(p)^1.5
};

/// Writes the clusters of a mesh into `data`, whose centre and diagonal are set.
class ClusterBuilder {
public:
    ClusterBuilder(const PreparedMesh& mesh, const Field& field, ExtractorData& data);

    void build();

private:
    /// Lists each cluster's vertices and finds where its memory begins. Returns the bytes needed.
    std::size_t lay_out();
    LocalVertex local_vertex(std::uint32_t v) const;
    void number_vertices(std::size_t cluster);
    /// What ClusterTriangle::neighbours has for a side of a triangle of a cluster.
    std::uint8_t neighbour(std::uint32_t triangle, int side, std::size_t cluster);
    void write_triangles(std::size_t cluster, unsigned char* memory);
    void write_vertices(std::size_t cluster, unsigned char* memory);
    void write_bounds(std::size_t cluster);

    const PreparedMesh& mesh_;
    const Field& field_;
    ExtractorData& data_;
    std::size_t edge_count_ = 0;
    const std::vector<TriangleSides> sides_;
    std::vector<std::uint32_t> order_;  // of the triangles, by cluster
    std::vector<ClusterRange> ranges_;
    std::vector<std::uint32_t> place_;            // of triangles in the order
    std::vector<std::size_t> first_vertex_;       // of each cluster in data_
    std::vector<std::uint32_t> border_number_;    // of edges, given one after the other
    std::vector<std::uint32_t> local_of_vertex_;  // while a cluster is written
    std::vector<LocalVertex> values_;             // of the cluster's vertices
};

}  // namespace laplacian_lines
