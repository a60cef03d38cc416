// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh as a redraw reads it, see cluster_data.h:
//  1. It is cut into clusters of neighbours, and what is across their borders is noted.
//  2. It is judged as a whole: sheet or body, contours along edges or not, what is convex and what
//     has no feature of its own.
//  3. Each cluster gets a place in one block of memory.
//  4. Clusters are written, several at once: triangles, vertices, the linear form n·v, and bounds
//     of the normals, by which a redraw skips what faces away. The forms of ΔI follow in
//     extractor_data.cpp.
#include "clusters/cluster_building.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "clusters/cluster_partition.h"
#include "clusters/coarseness.h"
#include "clusters/local_vertex.h"
#include "mesh/flat_faces.h"
#include "rules/thresholds.h"
#include "system/large_array.h"

namespace laplacian_lines {
namespace {

// About the part of the whole time at which each step ends.
constexpr double kPartitioned = 0.4, kLinked = 0.6, kLaidOut = 0.65;

// Least length of borders over the root of the area: 4 for a square, 2.5 for half a sphere.
constexpr double kLeastSheetBorders = 2;

class ClusterBuilder {
public:
    ClusterBuilder(const PreparedMesh& mesh, const Field& field, ExtractorData& data)
        : mesh_(mesh), field_(field), data_(data) {}

    void build(const StageProgress& stage) {
        stage.report(0);
        const CornerTable sides(mesh_.triangles, mesh_.size());
        judge_faces(sides);
        partition_ = partition(mesh_, sides);
        stage.report(kPartitioned);
        links_ = link_clusters(mesh_, sides, partition_);
        data_.border_edge_count = links_.number_count;
        data_.vertex_count = std::uint32_t(mesh_.size());
        judge_borders(sides);
        // judge_faces() has found is_cad, judge_borders() is_body
        if (follows_edges(mesh_, data_.is_cad, field_))
            data_.horizon = find_edge_horizon(mesh_, sides, data_.is_body);
        find_convex();
        stage.report(kLinked);
        data_.memory_of_clusters = large_array<ExtractorData::Unit>(lay_out());
        data_.bounds.resize((data_.clusters.size() + kFormGroup - 1) / kFormGroup);
        parallel_for<Values>(partition_.ranges.size(), stage.part(kLaidOut, 1),
                             [&](std::size_t c, Values& values) { write_cluster(c, values); });
    }

private:
    using Values = std::vector<LocalVertex>;  // of a cluster's vertices

    /// Finds the vertices where is_convex() holds, and those where it holds at all neighbours too.
    void find_convex() {
        convex_.resize(mesh_.size());
        for_each_element(mesh_.size(), [&](std::size_t v) {
            convex_[v] = is_convex(local_shape_operator(mesh_.original_vertex[v]));
        });
        convex_around_ = convex_;
        for (const Triangle& t : mesh_.triangles)
            if (!convex_[t[0]] || !convex_[t[1]] || !convex_[t[2]])
                convex_around_[t[0]] = convex_around_[t[1]] = convex_around_[t[2]] = 0;
    }

    /// Whether the mesh is one of CAD, and what its faces are.
    void judge_faces(const CornerTable& sides) {
        const FlatFaces faces = flat_faces(mesh_, sides);
        data_.flat_share = faces.share;
        data_.is_cad = faces.is_cad_mesh();
        // edges of rough meshes, and faces between them, are those of noise or of voxels
        shapes_ = data_.is_rough ? std::vector<FaceShape>(mesh_.triangles.size(), FaceShape::Curved)
                                 : face_shapes(mesh_, sides, faces);
        featureless_ = find_featureless_triangles(mesh_, shapes_);
    }

    /// Whether the mesh is a sheet, a closed body or neither.
    void judge_borders(const CornerTable& sides) {
        const double borders = sum_of(sides.side_count(), [&](std::size_t i) {
            const auto side = std::uint32_t(i);
            if (sides.across(side) != CornerTable::kBorder) return 0.;
            return (mesh_.positions[end_of(mesh_.triangles, side)] -
                    mesh_.positions[begin_of(mesh_.triangles, side)])
                .norm();
        });
        const std::vector<Triangle>& triangles = mesh_.triangles;
        if (borders > 0) {
            const double area = sum_of(triangles.size(), [&](std::size_t t) {
                return area_vector(mesh_, triangles[t]).norm() / 2;
            });
            data_.is_sheet = borders > kLeastSheetBorders * std::sqrt(area);
        } else if (2 * sides.edge_count() == sides.side_count() &&
                   field_.report.opposed_share == 0) {
            // two triangles an edge, of one orientation; else there is no inside
            const double volume = sum_of(triangles.size(), [&](std::size_t t) {  // six times
                return mesh_.positions[triangles[t][0]].dot(area_vector(mesh_, triangles[t]));
            });
            data_.is_body = volume > 0;
        }
    }

    /// Finds where the parts of each cluster begin. Returns the units that clusters need.
    std::size_t lay_out() {
        data_.clusters.resize(partition_.ranges.size());
        std::size_t units = 0, vertices = 0, edges = 0, groups = 0;
        for (std::size_t c = 0; c < data_.clusters.size(); ++c) {
            const ClusterRange& range = partition_.ranges[c];
            Cluster& cluster = data_.clusters[c];
            cluster.first_unit = std::uint32_t(units);
            cluster.first_border_edge = std::uint32_t(edges);
            cluster.vertex_count = std::uint8_t(range.vertex_count);
            cluster.first_vertex = std::uint32_t(vertices);
            cluster.triangle_count = std::uint8_t(range.end - range.begin);
            cluster.first_form_group = std::uint32_t(groups);
            groups += form_groups(cluster);
            units += cluster_layout(cluster).end / kCacheUnit;
            vertices += range.vertex_count;
            edges += std::size_t(std::count_if(
                links_.across.begin() + 3 * std::ptrdiff_t(range.begin),
                links_.across.begin() + 3 * std::ptrdiff_t(range.end), ClusterLinks::is_number));
        }
        data_.vertices_of_clusters.resize(vertices);
        data_.border_edges.resize(edges);
        return units;
    }

    void write_cluster(std::size_t c, Values& values) {
        const Cluster& cluster = data_.clusters[c];
        unsigned char* memory = reinterpret_cast<unsigned char*>(data_.memory_of_clusters.data()) +
                                cluster.first_unit * std::size_t(kCacheUnit);
        std::memset(memory, 0, cluster_layout(cluster).end);
        list_vertices(c, values);
        write_triangles(c, memory);
        mark_triangles(c);
        write_vertices(c, values, memory);
        write_facing_bounds(values, data_.bounds[c / kFormGroup], c % kFormGroup);
    }

    /// S·D of a vertex of the original mesh.
    ShapeOperator local_shape_operator(std::uint32_t v) const {
        const ShapeOperator& s = field_.shape_operators[v];
        const auto curvature = [&](float x) {
            return float(bounded(x * data_.diagonal, kLargestCurvature));
        };
        return {curvature(s.xx), curvature(s.yy), curvature(s.zz),
                curvature(s.yz), curvature(s.xz), curvature(s.xy)};
    }

    LocalVertex local_vertex(std::uint32_t prepared) const {
        const std::uint32_t v = mesh_.original_vertex[prepared];
        return {mesh_.positions[prepared], bounded(field_.normals[v], 1, 2),
                local_shape_operator(v)};
    }

    void list_vertices(std::size_t c, Values& values) {
        const ClusterRange& range = partition_.ranges[c];
        std::uint32_t* vertices =
            data_.vertices_of_clusters.data() + data_.clusters[c].first_vertex;
        for (std::uint32_t p = range.begin; p < range.end; ++p)
            for (std::size_t k = 0; k < 3; ++k)
                vertices[partition_.corners[3 * std::size_t(p) + k]] =
                    mesh_.triangles[partition_.order[p]][k];
        values.clear();
        for (std::uint32_t i = 0; i < range.vertex_count; ++i)
            values.push_back(local_vertex(vertices[i]));
    }

    void write_triangles(std::size_t c, unsigned char* memory) {
        const Cluster& cluster = data_.clusters[c];
        const ClusterLayout layout = cluster_layout(cluster);
        std::uint32_t* edges = data_.border_edges.data() + cluster.first_border_edge;
        unsigned edge_count = 0;
        const std::uint32_t first = partition_.ranges[c].begin;
        const auto neighbour = [&](std::uint32_t across) {
            if (across == ClusterLinks::kNobody) return kNoNeighbour;
            if (!ClusterLinks::is_number(across)) return std::uint8_t(across - first);
            edges[edge_count] = across - ClusterLinks::kNumber;
            return std::uint8_t(cluster.triangle_count + edge_count++);
        };
        for (unsigned i = 0; i < cluster.triangle_count; ++i) {
            unsigned char* corners = memory + layout.corners + place_of_corners(i);
            for (unsigned k = 0; k < 3; ++k) {
                const std::size_t side = 3 * std::size_t(first + i) + k;
                corners[k * kMaskGroup] = partition_.corners[side];
                memory[layout.neighbours + 3 * i + k] = neighbour(links_.across[side]);
            }
        }
    }

    void mark_triangles(std::size_t c) {
        Cluster& cluster = data_.clusters[c];
        const std::uint32_t first = partition_.ranges[c].begin;
        const auto mark = [&](std::uint64_t* bits, const auto& is_marked) {
            for (unsigned i = 0; i < cluster.triangle_count; ++i)
                bits[i / kMaskGroup] |= std::uint64_t(is_marked(i) ? 1 : 0) << i % kMaskGroup;
        };
        const auto all_corners = [&](const std::vector<std::uint8_t>& vertices) {
            return [&](unsigned i) {
                const Triangle& t = mesh_.triangles[partition_.order[first + i]];
                return vertices[t[0]] && vertices[t[1]] && vertices[t[2]];
            };
        };
        mark(cluster.convex, all_corners(convex_));
        mark(cluster.convex_around, all_corners(convex_around_));
        mark(cluster.featureless,
             [&](unsigned i) { return featureless_[partition_.order[first + i]]; });
        mark(cluster.enclosed, [&](unsigned i) {
            return shapes_[partition_.order[first + i]] == FaceShape::Enclosed;
        });
    }

    void write_vertices(std::size_t c, const Values& values, unsigned char* memory) const {
        const Cluster& cluster = data_.clusters[c];
        const ClusterLayout layout = cluster_layout(cluster);
        auto* records = reinterpret_cast<VertexRecord*>(memory + layout.records);
        for (std::size_t i = 0; i < values.size(); ++i)
            records[i] = make_record(values[i]);
        write_forms(reinterpret_cast<FormGroup*>(memory), cluster, [&](unsigned i) {
            return FormVector{values[i].normal, values[i].position};
        });
    }

    const PreparedMesh& mesh_;
    const Field& field_;
    ExtractorData& data_;
    std::vector<FaceShape> shapes_;                     // by triangle of the mesh
    std::vector<std::uint8_t> featureless_;             // likewise
    std::vector<std::uint8_t> convex_, convex_around_;  // by vertex
    Partition partition_;
    ClusterLinks links_;
};

}  // namespace

void build_clusters(const PreparedMesh& mesh, const Field& field, const StageProgress& stage,
                    ExtractorData& data) {
    ClusterBuilder(mesh, field, data).build(stage);
}

}  // namespace laplacian_lines
