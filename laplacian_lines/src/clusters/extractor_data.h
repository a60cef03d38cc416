// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "clusters/cluster_data.h"
#include "clusters/laplacian_forms.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// The mesh as a redraw reads it, see cluster_data.h. Local coordinates x' = (x − centre)/D, so
/// that all thresholds are dimensionless as they stand.
struct ExtractorData {
    struct Free {
        void operator()(unsigned char* memory) const;
    };
    std::unique_ptr<unsigned char[], Free> memory_of_clusters;
    std::size_t bytes_of_clusters = 0;
    std::vector<Cluster> clusters;
    std::vector<std::uint32_t> vertices_of_clusters;  ///< in the prepared mesh, cluster by cluster
    std::uint32_t vertex_count = 0;                   ///< of the prepared mesh
    int undone_subdivisions = 0;                      ///< of the prepared mesh
    /// Of the vertices of clusters; empty if the field has no derivatives.
    std::vector<CurvatureRecord> curvatures;
    std::vector<std::uint32_t> border_edges;
    std::uint32_t border_edge_count = 0;  ///< the numbers in border_edges are below
    /// The arrays of ClusterStore about whole clusters, one after the other.
    std::vector<float> bounds;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the bounding box, mesh units
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of line sets
    double diagonal = 1;                               ///< D, mesh units
    double squared_scale = 0;                          ///< h_e of the records, D²
    LaplacianForms laplacians;                         ///< of the field that it was built of
    bool is_rough = false;  ///< edges of the mesh are those of noise or voxels, not of the form
    bool is_sheet = false;  ///< its borders are so long that it is seen from both sides

    /// Memory for the clusters, aligned to cache units, for the builder to fill, and for their
    /// bounds.
    /// @throws std::bad_alloc
    void allocate(std::size_t bytes);
    std::size_t padded_cluster_count() const;  ///< to whole groups of kFormGroup
    ClusterStore store() const { return store(laplacians); }
    ClusterStore store(const LaplacianForms& forms) const;  ///< with these instead of its own
    std::size_t memory() const;                             ///< bytes
};

inline Eigen::Vector3f position_of(const VertexRecord& record) {
    return Eigen::Map<const Eigen::Vector3f>(record.position);
}
inline Eigen::Vector3f normal_of(const VertexRecord& record) {
    const auto& columns = record.shape_operator;
    return {columns[0][3], columns[1][3], columns[2][3]};
}

/// A cluster with where its parts are.
struct PlacedCluster {
    const Cluster* cluster;
    std::uint32_t first_triangle;   ///< over all clusters
    const std::uint32_t* vertices;  ///< numbers in the prepared mesh
    ClusterTriangles triangles;
    const VertexRecord* records;
    const FormGroup* laplacians;        ///< those of ExtractorData
    const CurvatureRecord* curvatures;  ///< by vertex; null if there are none

    ClusterTriangle triangle(unsigned i) const { return triangle_at(triangles, i); }
};
std::vector<PlacedCluster> place_clusters(const ExtractorData& data);

/// Whether lines of a kind can be found: those of some need derivatives.
bool has_needs_of(LineKind kind, const ExtractorData& data);

/// LineExtractor::laplacian().
LaplacianForms build_laplacian_forms(const TriangleMesh& mesh, const Field& field,
                                     const ExtractorData& data);

/// LineExtractor::add_derivatives().
void add_derivatives(const TriangleMesh& mesh, const Field& field, ExtractorData& data);

/// @throws Error: FieldMismatch, InvalidMesh, EmptyMesh, Cancelled.
ExtractorData build_extractor_data(const TriangleMesh& mesh, const Field& field,
                                   const Progress& progress = {});

}  // namespace laplacian_lines
