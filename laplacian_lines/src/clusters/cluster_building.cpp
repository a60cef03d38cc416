// SPDX-License-Identifier: GPL-3.0-or-later
#include "clusters/cluster_building.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "clusters/bounded.h"
#include "clusters/coarseness.h"
#include "clusters/linear_forms.h"
#include "rules/convexity.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

// About the part of the whole time at which each step ends.
constexpr double kPartitioned = 0.4, kLinked = 0.6, kLaidOut = 0.65;

// Least length of borders over the root of the area: 4 for a square, 2.5 for half a sphere.
constexpr double kLeastSheetBorders = 2;

constexpr double kLargestSlopeScale = 1e15;

VertexRecord make_record(const LocalVertex& v) {
    const ShapeOperator& s = v.shape_operator;
    const Eigen::Vector3f n = v.normal.cast<float>();
    return {{float(v.position.x()), float(v.position.y()), float(v.position.z())},
            v.slope_scale,
            {{s.xx, s.xy, s.xz, n.x()}, {s.xy, s.yy, s.yz, n.y()}, {s.xz, s.yz, s.zz, n.z()}}};
}

/// A box with the axes of the vectors' covariance: about the smallest one.
struct VectorBox {
    Eigen::Vector3d centre;
    Eigen::Matrix3d half_axes;  ///< columns
};
VectorBox enclose_normals(const std::vector<LocalVertex>& values) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const LocalVertex& v : values) {
        sum += v.normal;
        squares += v.normal * v.normal.transpose();
    }
    const double n = double(values.size());
    const Eigen::Matrix3d covariance = squares / n - sum * sum.transpose() / (n * n);
    const Eigen::Matrix3d axes =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
    Eigen::Vector3d low = axes.transpose() * values[0].normal, high = low;
    for (const LocalVertex& v : values) {
        low = low.cwiseMin(axes.transpose() * v.normal);
        high = high.cwiseMax(axes.transpose() * v.normal);
    }
    return {axes * (low + high) / 2, axes * ((high - low) / 2).asDiagonal()};
}

Eigen::Vector3d centre_of(const std::vector<LocalVertex>& values) {
    Eigen::AlignedBox3d box;
    for (const LocalVertex& v : values)
        box.extend(v.position);
    return box.center();
}

}  // namespace

ClusterBuilder::ClusterBuilder(const PreparedMesh& mesh, const Field& field, ExtractorData& data)
    : mesh_(mesh), field_(field), data_(data), plain_(mesh) {}

void ClusterBuilder::build(const StageProgress& stage) {
    stage.report(0);
    coarse_ = find_coarse_triangles(mesh_, field_);
    const CornerTable sides(mesh_.triangles, mesh_.size());
    partition_ = partition(mesh_, sides, coarse_);
    stage.report(kPartitioned);
    links_ = link_clusters(mesh_, sides, coarse_, partition_);
    data_.border_edge_count = links_.number_count;
    data_.vertex_count = std::uint32_t(mesh_.size());
    data_.is_sheet = is_sheet();
    find_convex();
    stage.report(kLinked);
    data_.allocate(lay_out());
    parallel_for<Values>(partition_.ranges.size(), stage.part(kLaidOut, 1),
                         [&](std::size_t c, Values& values) { write_cluster(c, values); });
}

void ClusterBuilder::find_convex() {
    convex_.resize(mesh_.size());
    for_each_element(mesh_.size(), [&](std::size_t v) {
        convex_[v] = is_convex(local_shape_operator(mesh_.original_vertex[v]));
    });
    convex_around_ = convex_;
    for (const Triangle& t : mesh_.triangles)
        if (!convex_[t[0]] || !convex_[t[1]] || !convex_[t[2]])
            convex_around_[t[0]] = convex_around_[t[1]] = convex_around_[t[2]] = 0;
}

bool ClusterBuilder::is_sheet() const {
    const double borders = sum_of(3 * mesh_.triangles.size(), [&](std::size_t side) {
        if (links_.across[side] != ClusterLinks::kNobody) return 0.;
        const Triangle& t = mesh_.triangles[partition_.order[side / 3]];
        return (mesh_.positions[t[side % 3]] - mesh_.positions[t[(side + 1) % 3]]).norm();
    });
    if (borders == 0) return false;
    const double area = sum_of(mesh_.triangles.size(), [&](std::size_t i) {
        return area_vector(mesh_, mesh_.triangles[i]).norm() / 2;
    });
    return borders > kLeastSheetBorders * std::sqrt(area);
}

std::size_t ClusterBuilder::lay_out() {
    const std::size_t clusters = partition_.ranges.size();
    data_.clusters.resize(clusters);
    std::vector<std::uint32_t> shared_edges(clusters);
    in_parallel(clusters, [&](std::size_t c) {
        const auto sides = links_.across.begin();
        const ClusterRange& range = partition_.ranges[c];
        shared_edges[c] = std::uint32_t(std::count_if(sides + 3 * std::size_t(range.begin),
                                                      sides + 3 * std::size_t(range.end),
                                                      ClusterLinks::is_number));
    });
    std::size_t units = 0, vertices = 0, edges = 0, groups = 0;
    for (std::size_t c = 0; c < clusters; ++c) {
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
        edges += shared_edges[c];
    }
    data_.vertices_of_clusters.resize(vertices);
    data_.border_edges.resize(edges);
    return units * kCacheUnit;
}

void ClusterBuilder::write_cluster(std::size_t c, Values& values) {
    const Cluster& cluster = data_.clusters[c];
    unsigned char* memory =
        data_.memory_of_clusters.get() + cluster.first_unit * std::size_t(kCacheUnit);
    std::memset(memory, 0, cluster_layout(cluster).end);
    list_vertices(c, values);
    write_triangles(c, memory);
    mark_triangles(c);
    write_vertices(c, values, memory);
    write_bounds(c, values);
}

ShapeOperator ClusterBuilder::local_shape_operator(std::uint32_t v) const {
    const ShapeOperator& s = field_.shape_operators[v];
    const auto curvature = [&](float x) {
        return float(bounded(x * data_.diagonal, kLargestCurvature));
    };
    return {curvature(s.xx), curvature(s.yy), curvature(s.zz),
            curvature(s.yz), curvature(s.xz), curvature(s.xy)};
}

LocalVertex ClusterBuilder::local_vertex(std::uint32_t prepared) const {
    const std::uint32_t v = mesh_.original_vertex[prepared];
    // The smoothing of the normals follows the adaptive kernel, see PrecomputeOptions.
    const double ratio = double(field_.kernel_sizes[v]) / field_.scale.kernel_size;
    const double squared_effective = ratio * ratio * data_.squared_scale;  // h_e
    return {mesh_.positions[prepared], bounded(field_.normals[v], 1, 2), local_shape_operator(v),
            float(bounded(squared_effective * std::sqrt(squared_effective), kLargestSlopeScale))};
}

void ClusterBuilder::list_vertices(std::size_t c, Values& values) {
    const ClusterRange& range = partition_.ranges[c];
    std::uint32_t* vertices = data_.vertices_of_clusters.data() + data_.clusters[c].first_vertex;
    for (std::uint32_t p = range.begin; p < range.end; ++p)
        for (std::size_t k = 0; k < 3; ++k)
            vertices[partition_.corners[3 * std::size_t(p) + k]] =
                mesh_.triangles[partition_.order[p]][k];
    values.clear();
    for (std::uint32_t i = 0; i < range.vertex_count; ++i)
        values.push_back(local_vertex(vertices[i]));
}

void ClusterBuilder::write_triangles(std::size_t c, unsigned char* memory) {
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

void ClusterBuilder::mark_triangles(std::size_t c) {
    Cluster& cluster = data_.clusters[c];
    const std::uint32_t first = partition_.ranges[c].begin;
    const auto mark = [&](std::uint64_t* bits, const auto& is_marked) {
        for (unsigned i = 0; i < cluster.triangle_count; ++i)
            bits[i / kMaskGroup] |= std::uint64_t(is_marked(i)) << i % kMaskGroup;
    };
    const auto all_corners = [&](const std::vector<std::uint8_t>& vertices) {
        return [&](unsigned i) {
            const Triangle& t = mesh_.triangles[partition_.order[first + i]];
            return vertices[t[0]] && vertices[t[1]] && vertices[t[2]];
        };
    };
    mark(cluster.convex, all_corners(convex_));
    mark(cluster.convex_around, all_corners(convex_around_));
    mark(cluster.coarse, [&](unsigned i) { return coarse_[partition_.order[first + i]] != 0; });
    mark(cluster.plain, [&](unsigned i) { return plain_.contain(partition_.order[first + i]); });
}

void ClusterBuilder::write_vertices(std::size_t c, const Values& values,
                                    unsigned char* memory) const {
    const Cluster& cluster = data_.clusters[c];
    const ClusterLayout layout = cluster_layout(cluster);
    auto* records = reinterpret_cast<VertexRecord*>(memory + layout.records);
    for (std::size_t i = 0; i < values.size(); ++i)
        records[i] = make_record(values[i]);
    write_forms(reinterpret_cast<FormGroup*>(memory), cluster, [&](unsigned i) {
        return FormVector{values[i].normal, values[i].position};
    });
}

void ClusterBuilder::write_bounds(std::size_t c, const Values& values) {
    const Eigen::Vector3d centre = centre_of(values);
    const VectorBox normals = enclose_normals(values);
    double low = std::numeric_limits<double>::max(), high = -low;
    for (const LocalVertex& v : values) {
        const double height = v.normal.dot(v.position - centre);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    float* out = data_.bounds.data() + c;
    const auto write = [&](double number) {
        *out = float(number);
        out += data_.padded_cluster_count();
    };
    for (const auto& vector : {centre, normals.centre})
        for (const double x : vector)
            write(x);
    for (const auto& axis : normals.half_axes.colwise())
        for (const double x : axis)
            write(x);
    write((low + high) / 2);
    write((high - low) / 2);
}

}  // namespace laplacian_lines
