// SPDX-License-Identifier: GPL-3.0-or-later
#include "cluster_building.h"

#include <algorithm>
#include <cmath>

#include "convexity.h"

namespace laplacian_lines {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// Writes a vector v at p as the linear form of place i.
void write_form(float* forms, std::size_t i, const Eigen::Vector3d& v, const Eigen::Vector3d& p) {
    float* place = forms + i / kFormGroup * 4 * kFormGroup + i % kFormGroup;
    for (unsigned k = 0; k < 3; ++k)
        place[k * kFormGroup] = float(v[k]);
    place[3 * kFormGroup] = float(v.dot(p));
}

VertexRecord make_record(const LocalVertex& v) {
    const ShapeOperator& s = v.shape_operator;
    const Eigen::Vector3f n = v.normal.cast<float>();
    return {{float(v.position.x()), float(v.position.y()), float(v.position.z())},
            v.slope_scale,
            {{s.xx, s.xy, s.xz, n.x()}, {s.xy, s.yy, s.yz, n.y()}, {s.xz, s.yz, s.zz, n.z()}}};
}

/// Writes centre and radius of a ball around a member of the values to four arrays, one float
/// each, `stride` apart. It is the ball around the bounding box's centre.
void write_ball(const std::vector<LocalVertex>& values, Eigen::Vector3d LocalVertex::*member,
                float* out, std::size_t stride) {
    Eigen::Vector3d low = values[0].*member, high = low;
    for (const LocalVertex& v : values) {
        low = low.cwiseMin(v.*member);
        high = high.cwiseMax(v.*member);
    }
    const Eigen::Vector3f centre = (low / 2 + high / 2).cast<float>();
    double radius = 0;
    for (const LocalVertex& v : values)
        radius = std::max(radius, (v.*member - centre.cast<double>()).norm());
    for (std::size_t k = 0; k < 3; ++k)
        out[k * stride] = centre[Eigen::Index(k)];
    out[3 * stride] = float(radius);
}

}  // namespace

ClusterBuilder::ClusterBuilder(const PreparedMesh& mesh, const Field& field, ExtractorData& data)
    : mesh_(mesh),
      field_(field),
      data_(data),
      sides_(find_sides(mesh, edge_count_)),
      ranges_(partition(mesh, sides_, order_)),
      place_(mesh.triangles.size()),
      border_number_(edge_count_, kNone),
      local_of_vertex_(mesh.size(), kNone) {
    for (const ClusterRange& r : ranges_)  // in the input's order, which often has some sense
        std::sort(order_.begin() + r.begin, order_.begin() + r.end);
    for (std::uint32_t i = 0; i < order_.size(); ++i)
        place_[order_[i]] = i;
}

void ClusterBuilder::build() {
    data_.allocate(lay_out());
    for (std::size_t c = 0; c < ranges_.size(); ++c) {
        unsigned char* memory =
            data_.memory_of_clusters.get() + data_.clusters[c].first_line * std::size_t(kCacheLine);
        number_vertices(c);
        write_triangles(c, memory);
        write_vertices(c, memory);
        write_bounds(c);
    }
}

std::size_t ClusterBuilder::lay_out() {
    data_.clusters.resize(ranges_.size());
    data_.vertex_count = std::uint32_t(mesh_.size());
    std::vector<std::uint32_t>& vertices = data_.vertices_of_clusters;
    std::size_t lines = 0;
    for (std::size_t c = 0; c < ranges_.size(); ++c) {
        first_vertex_.push_back(vertices.size());
        for (std::uint32_t i = ranges_[c].begin; i < ranges_[c].end; ++i)
            for (std::uint32_t v : mesh_.triangles[order_[i]])
                if (local_of_vertex_[v] != c) {  // the cluster that had it last
                    local_of_vertex_[v] = std::uint32_t(c);
                    vertices.push_back(v);
                }
        Cluster& cluster = data_.clusters[c];
        cluster.first_line = std::uint32_t(lines);
        cluster.vertex_count = std::uint8_t(vertices.size() - first_vertex_[c]);
        cluster.triangle_count = std::uint8_t(ranges_[c].end - ranges_[c].begin);
        lines += cluster_layout(cluster).end / kCacheLine;
    }
    vertices.shrink_to_fit();
    return lines * kCacheLine;
}

LocalVertex ClusterBuilder::local_vertex(std::uint32_t prepared) const {
    const std::uint32_t v = mesh_.original_vertex[prepared];
    const double d = data_.diagonal;
    const ShapeOperator& s = field_.shape_operators[v];
    const float f = float(d);
    const double size = field_.kernel_sizes[v] / d;
    // The smoothing of the normals follows the adaptive kernel, see PrecomputeOptions.
    const FieldScale& scale = field_.scale;
    const double sigma = scale.normal_sigma / d * (size / (scale.kernel_size / scale.diagonal));
    return {mesh_.positions[prepared],
            field_.normals[v].cast<double>(),
            field_.laplacian_normals[v].cast<double>() * d * d,
            {s.xx * f, s.yy * f, s.zz * f, s.yz * f, s.xz * f, s.xy * f},
            float(std::pow(size * size + sigma * sigma / 2, 1.5))};
}

void ClusterBuilder::number_vertices(std::size_t c) {
    values_.clear();
    for (std::uint32_t i = 0; i < data_.clusters[c].vertex_count; ++i) {
        const std::uint32_t v = data_.vertices_of_clusters[first_vertex_[c] + i];
        local_of_vertex_[v] = i;
        values_.push_back(local_vertex(v));
    }
}

std::uint8_t ClusterBuilder::neighbour(std::uint32_t triangle, int side, std::size_t c) {
    const TriangleSides& sides = sides_[triangle];
    const std::uint32_t other = sides.neighbours[side];
    if (other == TriangleSides::kNone) return kNoNeighbour;
    const std::uint32_t place = place_[other];
    if (!sides.reversed[side] && place >= ranges_[c].begin && place < ranges_[c].end)
        return std::uint8_t(place - ranges_[c].begin);
    std::uint32_t& number = border_number_[sides.edges[side]];
    if (number == kNone) number = data_.border_edge_count++;
    data_.border_edges.push_back(number);
    const Cluster& cluster = data_.clusters[c];
    return std::uint8_t(cluster.triangle_count + data_.border_edges.size() - 1 -
                        cluster.first_border_edge);
}

void ClusterBuilder::write_triangles(std::size_t c, unsigned char* memory) {
    Cluster& cluster = data_.clusters[c];
    cluster.first_border_edge = std::uint32_t(data_.border_edges.size());
    const ClusterLayout layout = cluster_layout(cluster);
    auto* triangles = reinterpret_cast<ClusterTriangle*>(memory + layout.triangles);
    for (unsigned i = 0; i < cluster.triangle_count; ++i) {
        const std::uint32_t t = order_[ranges_[c].begin + i];
        ClusterTriangle& triangle = triangles[i];
        unsigned char* corners = memory + layout.corners + i / kMaskGroup * 3 * kMaskGroup;
        for (int k = 0; k < 3; ++k) {
            const auto local = std::uint8_t(local_of_vertex_[mesh_.triangles[t][std::size_t(k)]]);
            corners[unsigned(k) * kMaskGroup + i % kMaskGroup] = triangle.corners[k] = local;
            triangle.neighbours[k] = neighbour(t, k, c);
        }
        triangle.number = std::uint8_t(i);
        const auto convex = [&](std::uint8_t corner) {
            return is_convex(values_[corner].shape_operator);
        };
        if (std::all_of(triangle.corners, triangle.corners + 3, convex))
            cluster.convex[i / kMaskGroup] |= std::uint64_t(1) << i % kMaskGroup;
    }
}

void ClusterBuilder::write_vertices(std::size_t c, unsigned char* memory) {
    const Cluster& cluster = data_.clusters[c];
    const ClusterLayout layout = cluster_layout(cluster);
    auto* normals = reinterpret_cast<float*>(memory);
    auto* laplacians = reinterpret_cast<float*>(memory + layout.laplacians);
    auto* records = reinterpret_cast<VertexRecord*>(memory + layout.records);
    for (std::size_t i = 0; i < values_.size(); ++i)
        records[i] = make_record(values_[i]);
    // The places that are left over repeat the last vertex, which changes no "all" or "any".
    for (std::size_t i = 0; i < form_groups(cluster) * kFormGroup; ++i) {
        const LocalVertex& v = values_[std::min(i, values_.size() - 1)];
        write_form(normals, i, v.normal, v.position);
        write_form(laplacians, i, v.laplacian, v.position);
    }
}

void ClusterBuilder::write_bounds(std::size_t c) {
    const std::size_t stride = data_.padded_cluster_count();
    float* out = data_.bounds.data() + c;
    for (auto member : {&LocalVertex::position, &LocalVertex::normal, &LocalVertex::laplacian}) {
        write_ball(values_, member, out, stride);
        out += 4 * stride;
    }
}

}  // namespace laplacian_lines
