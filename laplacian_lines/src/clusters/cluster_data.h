// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "system/cache.h"

/// What a redraw reads: the mesh cut into clusters of neighbouring triangles, each in one piece of
/// memory. Plain data and static functions only, since files that are compiled for several
/// instruction sets include this.
namespace laplacian_lines {

constexpr unsigned kClusterVertices = 128;   ///< at most; a set of signs is 128 bits
constexpr unsigned kClusterTriangles = 192;  ///< at most
/// Triangles of a cluster and its sides to others, see ClusterTriangle, have a common numbering:
/// side e has the number triangle_count + e. At most this many numbers.
constexpr unsigned kClusterNumbers = 255;
constexpr std::uint8_t kNoNeighbour = 255;

constexpr unsigned kFormGroup = 16;  ///< vertices whose linear forms lie together
constexpr unsigned kMaskGroup = 64;  ///< triangles whose corners lie together

/// Linear forms v·(e − w p) that are kept of each vertex.
enum VertexForm : unsigned {
    kFacingForm,     ///< v = n
    kLaplacianForm,  ///< v = Δn·D²
    kVertexFormCount
};

/// Position, shape operator and normal of a vertex in local coordinates x' = (x − centre)/D: one
/// cache unit, as rows of four.
struct VertexRecord {
    float position[4];           ///< and 0
    float shape_operator[3][4];  ///< columns of S·D, each with a component of the normal
};
static_assert(sizeof(VertexRecord) == kCacheUnit, "a vertex record is one cache unit");

/// What kinds of lines that need S̄ and C read of a vertex: likewise local, rows of four.
struct alignas(kCacheUnit) CurvatureRecord {
    float position[4], normal[4];  ///< and 0
    float curvature[4];            ///< S̄·D as in the field, and 0
    float derivative[4];           ///< C·D² as in the field
};
static_assert(sizeof(CurvatureRecord) == kCacheUnit, "a curvature record is one cache unit");

/// Corners in cyclic order; neighbour k is across the edge from corner k to the next: the number of
/// a triangle of the cluster with the same orientation, else of a side to another one, or
/// kNoNeighbour where lines end (borders, edges of more than two triangles).
struct ClusterTriangle {
    std::uint8_t corners[3];
    std::uint8_t neighbours[3];
};
/// Those of a cluster in its memory: corners apart, as the sign tests read them, for each
/// kMaskGroup triangles all first ones, then all second, all third; three neighbours of each.
struct ClusterTriangles {
    const std::uint8_t *corners, *neighbours;
};
/// Where the first corner of a triangle is; each other one is kMaskGroup bytes further.
static inline unsigned place_of_corners(unsigned triangle) {
    return triangle / kMaskGroup * 3 * kMaskGroup + triangle % kMaskGroup;
}
static inline ClusterTriangle triangle_at(const ClusterTriangles& triangles, unsigned i) {
    const std::uint8_t* c = triangles.corners + place_of_corners(i);
    const std::uint8_t* n = triangles.neighbours + 3 * i;
    return {{c[0], c[kMaskGroup], c[2 * kMaskGroup]}, {n[0], n[1], n[2]}};
}

/// The linear forms of some vertices: v.x of all, then v.y, v.z, and v·p.
struct alignas(kCacheUnit) FormGroup {
    float numbers[4][kFormGroup];
};

/// The memory of a cluster, from `first_unit` on, each part beginning a cache unit:
///  - the FormGroups of all vertices, of kFacingForm,
///  - ClusterTriangles: the corners, then the neighbours,
///  - VertexRecord of each vertex.
struct Cluster {
    std::uint32_t first_unit;         ///< in units of kCacheUnit
    std::uint32_t first_border_edge;  ///< in ClusterStore::border_edges
    std::uint32_t first_form_group;   ///< in ClusterStore::laplacians
    std::uint8_t vertex_count, triangle_count;
    std::uint32_t first_vertex;  ///< the first of its vertices, over all clusters
    /// A bit for each triangle: is_convex() at all corners, see LineRules::leave_out_convex; and at
    /// their neighbours.
    std::uint64_t convex[kClusterTriangles / kMaskGroup];
    std::uint64_t convex_around[kClusterTriangles / kMaskGroup];
    /// A bit for each triangle: of find_featureless_triangles(), see LineRules::drop_featureless.
    std::uint64_t featureless[kClusterTriangles / kMaskGroup];
    std::uint64_t enclosed[kClusterTriangles / kMaskGroup];  ///< likewise: of FaceShape::Enclosed
};

/// Offsets of the parts, in bytes.
struct ClusterLayout {
    std::size_t corners, neighbours, records, end;
};

static inline unsigned form_groups(const Cluster& c) {
    return (c.vertex_count + kFormGroup - 1) / kFormGroup;
}
static inline unsigned mask_groups(const Cluster& c) {
    return (c.triangle_count + kMaskGroup - 1) / kMaskGroup;
}
static inline ClusterLayout cluster_layout(const Cluster& c) {
    ClusterLayout layout;
    layout.corners = form_groups(c) * sizeof(FormGroup);
    layout.neighbours = layout.corners + mask_groups(c) * 3 * kMaskGroup;
    layout.records =
        layout.neighbours + (3u * c.triangle_count + kCacheUnit - 1) / kCacheUnit * kCacheUnit;
    layout.end = layout.records + c.vertex_count * sizeof(VertexRecord);
    return layout;
}

/// Bounds of n·(e − w p) over the vertices of clusters, of kFormGroup of them one number after the
/// other. With the centre of the cluster c, n is within normal ± axes[0] ± axes[1] ± axes[2], and
/// n·(p − c) is within height ± height_range.
struct alignas(kCacheUnit) FacingBounds {
    float centre[3][kFormGroup];
    float normal[3][kFormGroup];
    float axes[3][3][kFormGroup];
    float height[kFormGroup], height_range[kFormGroup];
};

/// All clusters, without their ownership.
struct ClusterStore {
    const unsigned char* memory;
    const Cluster* clusters;
    const std::uint32_t* border_edges;  ///< numbers of edges over the whole mesh
    const FormGroup* laplacians;        ///< linear forms of Δn, cluster by cluster
    const FacingBounds* facing;         ///< by kFormGroup clusters
    const CurvatureRecord* curvatures;  ///< of the vertices of clusters; or null
};

/// All memory as records, to be indexed in units of them.
static inline const VertexRecord* records_of(const ClusterStore& store) {
    return reinterpret_cast<const VertexRecord*>(store.memory);
}
static inline const unsigned char* memory_of(const ClusterStore& store, const Cluster& cluster) {
    return store.memory + cluster.first_unit * std::size_t(kCacheUnit);
}
static inline ClusterTriangles triangles_of(const ClusterStore& store, const Cluster& cluster) {
    const unsigned char* memory = memory_of(store, cluster);
    const ClusterLayout layout = cluster_layout(cluster);
    return {memory + layout.corners, memory + layout.neighbours};
}

}  // namespace laplacian_lines
