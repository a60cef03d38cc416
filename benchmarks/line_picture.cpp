// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "laplacian_lines/line_visibility.h"

namespace benchmarks {

using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::Polyline;
using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

namespace {

/// For each vertex the first one at its place.
std::vector<std::uint32_t> first_at_place(const TriangleMesh& mesh) {
    std::map<std::array<double, 3>, std::uint32_t> places;
    std::vector<std::uint32_t> first;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const auto vertex = std::uint32_t(v);
        if (!mesh.positions[v].allFinite()) {
            first.push_back(vertex);
            continue;
        }
        const Eigen::Vector3d p = mesh.positions[v] + Eigen::Vector3d::Zero();  // -0 and 0 are one
        first.push_back(places.try_emplace({p.x(), p.y(), p.z()}, vertex).first->second);
    }
    return first;
}

/// A triangle at an edge.
struct EdgeSide {
    std::pair<std::uint32_t, std::uint32_t> edge;  // lower vertex first
    bool forwards;                                 // goes from the lower to the higher one
    std::uint32_t triangle;
};

std::vector<EdgeSide> sorted_sides(const TriangleMesh& mesh) {
    const std::vector<std::uint32_t> vertex = first_at_place(mesh);
    std::vector<EdgeSide> sides;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = vertex[mesh.triangles[t][std::size_t(k)]],
                                b = vertex[mesh.triangles[t][std::size_t((k + 1) % 3)]];
            sides.push_back({std::minmax({a, b}), a < b, std::uint32_t(t)});
        }
    std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
        return std::pair(a.edge, a.triangle) < std::pair(b.edge, b.triangle);
    });
    return sides;
}

Eigen::Vector3d normal(const TriangleMesh& mesh, const EdgeSide& side) {
    const Triangle& t = mesh.triangles[side.triangle];
    const Eigen::Vector3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]],
                          &c = mesh.positions[t[2]];
    const Eigen::Vector3d n = (b - a).cross(c - a).normalized();
    return side.forwards ? n : Eigen::Vector3d(-n);
}

void set_pixel(const Eigen::Vector3d& place, PixelMask& mask) {
    mask.set(int(std::floor(place.x())), int(std::floor(place.y())));
}

/// Whether no surface lies nearer than a place by more than `clearance`.
bool is_in_sight(const DepthPicture& surface, const Eigen::Vector3d& place, double clearance) {
    const std::int32_t t =
        surface.triangle_at(int(std::floor(place.x())), int(std::floor(place.y())));
    return t < 0 || surface.plane_depth(t, place.x(), place.y()) >= place.z() - clearance;
}

/// Where lines have enough ink and `counts`(line, place).
template <class Counts>
PixelMask pixels_with_ink(const PictureCamera& camera, const LineSet& lines, Counts counts) {
    PixelMask mask(camera.size());
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
            const LinePoint &a = lines.points[i - 1], &b = lines.points[i];
            for_each_place(camera, a.position.cast<double>(), b.position.cast<double>(),
                           [&](double share, const Eigen::Vector3d& p) {
                               const double weight = (1 - share) * a.weight + share * b.weight;
                               const double opacity = (1 - share) * a.opacity + share * b.opacity;
                               if (weight * opacity >= kLeastInk && counts(line, p))
                                   set_pixel(p, mask);
                           });
        }
    return mask;
}

}  // namespace

void for_each_place(const PictureCamera& camera, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& to,
                    const std::function<void(double, const Eigen::Vector3d&)>& use) {
    const Eigen::Vector3d way = camera.project(to) - camera.project(from);
    const int steps = std::max(1, int(std::ceil(2 * way.head<2>().norm())));
    for (int i = 0; i <= steps; ++i) {
        const double share = double(i) / steps;
        use(share, camera.project((1 - share) * from + share * to));
    }
}

PixelMask line_pixels(const PictureCamera& camera, const LineSet& lines) {
    return pixels_with_ink(camera, lines,
                           [](const Polyline&, const Eigen::Vector3d&) { return true; });
}

PixelMask line_pixels_in_sight(const PictureCamera& camera, const DepthPicture& surface,
                               const LineSet& lines, double diagonal, double sight_edge) {
    return pixels_with_ink(camera, lines, [&](const Polyline& line, const Eigen::Vector3d& p) {
        return is_in_sight(surface, p, sight_clearance(line.kind, diagonal, sight_edge));
    });
}

std::vector<EdgeEnds> sharp_edges(const TriangleMesh& mesh, double degrees) {
    const double largest_cosine = std::cos(degrees * std::acos(-1.0) / 180) + 1e-9;
    const std::vector<EdgeSide> sides = sorted_sides(mesh);
    std::vector<EdgeEnds> edges;
    for (std::size_t i = 0, end; i < sides.size(); i = end) {
        for (end = i + 1; end < sides.size() && sides[end].edge == sides[i].edge;)
            ++end;
        if (end - i != 2) continue;
        // Of two triangles that agree about the outside, one goes backwards.
        if (normal(mesh, sides[i]).dot(-normal(mesh, sides[i + 1])) > largest_cosine) continue;
        edges.push_back(
            {mesh.positions[sides[i].edge.first], mesh.positions[sides[i].edge.second]});
    }
    return edges;
}

PixelMask edge_pixels(const PictureCamera& camera, const DepthPicture& surface,
                      const std::vector<EdgeEnds>& edges, double clearance) {
    PixelMask mask(camera.size());
    for (const EdgeEnds& edge : edges)
        for_each_place(camera, edge.from, edge.to, [&](double, const Eigen::Vector3d& p) {
            if (is_in_sight(surface, p, clearance)) set_pixel(p, mask);
        });
    return mask;
}

}  // namespace benchmarks
