// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "clusters/cluster_data.h"
#include "clusters/edge_horizon.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"

namespace laplacian_lines {

/// The mesh as a redraw reads it, see cluster_data.h. Local coordinates x' = (x − centre)/D, so
/// that all thresholds are dimensionless as they stand.
struct ExtractorData {
    struct alignas(kCacheUnit) Unit {
        Unit() {}  // nothing is cleared
        unsigned char bytes[kCacheUnit];
    };
    std::vector<Unit> memory_of_clusters;
    std::vector<Cluster> clusters;
    std::vector<std::uint32_t> vertices_of_clusters;  ///< in the prepared mesh, cluster by cluster
    std::uint32_t vertex_count = 0;                   ///< of the prepared mesh
    /// Of the vertices of clusters; empty if the field has no derivatives.
    std::vector<CurvatureRecord> curvatures;
    std::vector<std::uint32_t> border_edges;
    std::uint32_t border_edge_count = 0;  ///< numbers in border_edges are less
    std::vector<FacingBounds> bounds;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the bounding box, mesh units
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of line sets
    double diagonal = 1;                               ///< D, mesh units
    std::vector<FormGroup> laplacians;                 ///< linear forms of Δn, cluster by cluster
    float kernel_size = 0;                             ///< √h of Δn, D
    double squared_scale = 0;                          ///< h_e that slopes are measured by, D²
    double laplacian_squared_scale = 0;                ///< that of slopes of Laplacian lines
    double flat_share = 0;                             ///< of the area, see flat_faces.h
    bool is_cad = false;                               ///< FlatFaces::is_cad_mesh()
    bool is_rough = false;  ///< edges of the mesh are those of noise or voxels, not of the form
    bool is_sheet = false;  ///< its borders are so long that it is seen from both sides
    /// Closed, two triangles of one orientation an edge (unlike a Klein bottle), facing outwards:
    /// it hides what faces away.
    bool is_body = false;
    EdgeHorizon horizon;  ///< empty where contours are zeros of n·v

    ClusterStore store() const;
    std::size_t memory() const;  ///< bytes

    /// A local position as line sets have it, and back.
    Eigen::Vector3f in_line_set(const Eigen::Vector3f& local) const {
        return (centre - origin + diagonal * local.cast<double>()).cast<float>();
    }
    Eigen::Vector3f local_of(const Eigen::Vector3f& in_line_set) const {
        return ((origin - centre + in_line_set.cast<double>()) / diagonal).cast<float>();
    }
};

/// A homogeneous point in local coordinates, scaled so that n·(eye − w p) is about in [−1, 1].
struct LocalEye {
    Eigen::Vector3f eye;
    float w;

    Eigen::Vector3f towards(const Eigen::Vector3f& p) const { return eye - w * p; }
};

/// Whether the eye may be inside, from where back faces are what is seen.
inline bool may_be_within(const LocalEye& eye) {
    return eye.eye.norm() < 0.5f * eye.w;  // a ball around the mesh
}

inline Eigen::Vector3f position_of(const VertexRecord& record) {
    return Eigen::Map<const Eigen::Vector3f>(record.position);
}
inline Eigen::Vector3f normal_of(const VertexRecord& record) {
    const auto& columns = record.shape_operator;
    return {columns[0][3], columns[1][3], columns[2][3]};
}

/// The vector of a vertex's form.
inline Eigen::Vector3f vector_of_form(const FormGroup* groups, unsigned vertex) {
    const auto& numbers = groups[vertex / kFormGroup].numbers;
    const unsigned i = vertex % kFormGroup;
    return {numbers[0][i], numbers[1][i], numbers[2][i]};
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
    bool is_enclosed(unsigned i) const {
        return cluster->enclosed[i / kMaskGroup] >> i % kMaskGroup & 1;
    }
};
std::vector<PlacedCluster> place_clusters(const ExtractorData& data);

/// Whether lines of a kind can be found: those of some need derivatives.
bool can_extract(LineKind kind, const ExtractorData& data);

/// LineExtractor::add_derivatives().
void add_derivatives(const TriangleMesh& mesh, const Field& field, ExtractorData& data);

/// @throws Error: FieldMismatch, InvalidMesh, EmptyMesh, Cancelled.
ExtractorData build_extractor_data(const TriangleMesh& mesh, const Field& field,
                                   const Progress& progress = {});

}  // namespace laplacian_lines
