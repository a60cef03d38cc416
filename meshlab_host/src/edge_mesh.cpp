// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/edge_mesh.h"

#include <vcg/space/index/kdtree/kdtree.h>

#include <Eigen/Geometry>
#include <QColor>
#include <algorithm>

#include "attributes.h"

namespace meshlab_host {

using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::Polyline;
using laplacian_lines::TriangleMesh;

namespace {

std::uint32_t vertex_count(const Polyline& line) {
    return line.closed ? line.count - 1 : line.count;
}

/// Calls visit(vertex, point, line, number of the line), in order.
template <class Visit>
void visit_vertices(const LineSet& lines, Visit visit) {
    std::size_t vertex = 0;
    for (std::size_t number = 0; number < lines.lines.size(); ++number) {
        const Polyline& line = lines.lines[number];
        for (std::uint32_t i = 0; i < vertex_count(line); ++i)
            visit(vertex++, lines.points[line.first + i], line, number);
    }
}

void add_vertices(const LineSet& lines, CMeshO& mesh) {
    std::size_t count = 0;
    for (const Polyline& line : lines.lines)
        count += vertex_count(line);
    vcg::tri::Allocator<CMeshO>::AddVertices(mesh, count);
    visit_vertices(lines,
                   [&](std::size_t vertex, const LinePoint& point, const Polyline&, std::size_t) {
                       mesh.vert[vertex].P() = point_of(lines.position(point));
                       mesh.vert[vertex].Q() = Scalarm(point.weight * point.opacity);
                   });
}

void add_edges(const LineSet& lines, CMeshO& mesh) {
    auto edge = vcg::tri::Allocator<CMeshO>::AddEdges(mesh, lines.segment_count());
    std::size_t first = 0;
    for (const Polyline& line : lines.lines) {
        const std::uint32_t vertices = vertex_count(line);
        for (std::uint32_t i = 0; i + 1 < line.count; ++i, ++edge) {
            edge->V(0) = &mesh.vert[first + i];
            edge->V(1) = &mesh.vert[first + (i + 1) % vertices];
        }
        first += vertices;
    }
}

/// By vertex, the sum over its triangles of normals as long as twice their area, where finite.
std::vector<Eigen::Vector3d> normals_of(const TriangleMesh& surface) {
    std::vector<Eigen::Vector3d> normals(surface.positions.size(), Eigen::Vector3d::Zero());
    for (const laplacian_lines::Triangle& t : surface.triangles) {
        const Eigen::Vector3d& a = surface.positions[t[0]];
        const Eigen::Vector3d n = (surface.positions[t[1]] - a).cross(surface.positions[t[2]] - a);
        if (!n.allFinite()) continue;
        for (const std::uint32_t v : t)
            normals[v] += n;
    }
    return normals;
}

/// The vertices of a surface that have normals, as MeshLab's numbers.
struct OrientedPoints {
    explicit OrientedPoints(const TriangleMesh& surface) {
        const std::vector<Eigen::Vector3d> all = normals_of(surface);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Eigen::Vector3d n = all[i].stableNormalized();
            if (n.isZero(0)) continue;
            positions.push_back(point_of(surface.positions[i]));
            normals.push_back(point_of(n));
        }
    }

    std::vector<Point3m> positions, normals;
};

}  // namespace

void to_edge_mesh(const LineSet& lines, CMeshO& mesh) {
    add_vertices(lines, mesh);
    add_edges(lines, mesh);
    const auto column = [&](const char* name) {
        return ensure_vertex_values<Scalarm>(mesh, name).data();
    };
    Scalarm *const numbers = column("ll_line"), *const kinds = column("ll_kind"),
                   *const strengths = column("ll_strength"), *const slopes = column("ll_slope"),
                   *const weights = column("ll_weight"), *const gradients = column("ll_gradient"),
                   *const opacities = column("ll_opacity");
    visit_vertices(lines, [&](std::size_t vertex, const LinePoint& point, const Polyline& line,
                              std::size_t number) {
        numbers[vertex] = Scalarm(number);
        kinds[vertex] = Scalarm(int(line.kind));
        strengths[vertex] = line.strength;
        slopes[vertex] = std::max(line.slope, 0.f);
        weights[vertex] = point.weight;
        gradients[vertex] = point.gradient;
        opacities[vertex] = point.opacity;
    });
    vcg::tri::UpdateBounding<CMeshO>::Box(mesh);
}

void set_colors(const LineSet& lines, const KindColors& colors, CMeshO& mesh) {
    visit_vertices(
        lines, [&](std::size_t vertex, const LinePoint&, const Polyline& line, std::size_t) {
            const QColor color(colors.at(std::size_t(line.kind)));
            mesh.vert[vertex].C() = vcg::Color4b(color.red(), color.green(), color.blue(), 255);
        });
}

void set_normals(const TriangleMesh& surface, CMeshO& mesh) {
    const OrientedPoints points(surface);
    if (points.positions.empty()) return;
    vcg::KdTree<Scalarm> tree(vcg::ConstDataWrapper<Point3m>(
        points.positions.data(), int(points.positions.size()), sizeof(Point3m)));
    for (auto& vertex : mesh.vert) {
        unsigned int nearest = 0;
        Scalarm distance = 0;
        tree.doQueryClosest(vertex.cP(), nearest, distance);
        vertex.N() = points.normals[nearest];
    }
}

}  // namespace meshlab_host
