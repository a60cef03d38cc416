// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clusters/cluster_sides.h"
#include "clusters/extractor_data.h"
#include "clusters/plain_places.h"
#include "system/parallel.h"

namespace laplacian_lines {

/// Values of a vertex as clusters hold them, local.
struct LocalVertex {
    Eigen::Vector3d position, normal;
    ShapeOperator shape_operator;  ///< S·D
    float slope_scale;             ///< h_e(p)^1.5
};

/// Writes the clusters of a mesh into `data`, whose centre and diagonal are set. The number of
/// threads does not matter.
class ClusterBuilder {
public:
    ClusterBuilder(const PreparedMesh& mesh, const Field& field, ExtractorData& data);

    void build(const StageProgress& stage);

private:
    using Values = std::vector<LocalVertex>;  // of a cluster's vertices

    bool is_sheet() const;
    /// Finds the vertices that are convex by is_convex(), as are all their neighbours.
    void find_convex();
    /// Finds where the parts of each cluster begin. Returns the bytes that clusters need.
    std::size_t lay_out();
    void write_cluster(std::size_t cluster, Values& values);
    /// S·D of a vertex of the original mesh.
    ShapeOperator local_shape_operator(std::uint32_t v) const;
    LocalVertex local_vertex(std::uint32_t v) const;
    /// Lists the cluster's vertices with their values.
    void list_vertices(std::size_t cluster, Values& values);
    void write_triangles(std::size_t cluster, unsigned char* memory);
    void mark_triangles(std::size_t cluster);
    void write_vertices(std::size_t cluster, const Values& values, unsigned char* memory) const;
    void write_bounds(std::size_t cluster, const Values& values);

    const PreparedMesh& mesh_;
    const Field& field_;
    ExtractorData& data_;
    std::vector<std::uint8_t> coarse_;                  // by triangle of the mesh
    std::vector<std::uint8_t> convex_, convex_around_;  // by vertex
    const PlainPlaces plain_;
    Partition partition_;
    ClusterLinks links_;
};

}  // namespace laplacian_lines
