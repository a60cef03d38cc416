// SPDX-License-Identifier: GPL-3.0-or-later
// How triangles are turned outwards:
//  1. Neighbours across edges of two triangles are made to agree with a first triangle; what is
//     connected so is a body.
//  2. A closed body, also one with holes, is turned as a whole if its volume is negative; an open
//     one if step 1 has turned most of its area.
//  3. A closed body inside another one, found by a ray, is turned with that one if it was: it is a
//     cavity of it or a part within.
#include "mesh/orientation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "mesh/box_tree.h"
#include "mesh/corner_table.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

// A closed surface has holes of at most these borders, and a volume.
constexpr double kMostBordersOfHoles = 0.02;  // share of the edges
constexpr double kMostOpen = 0.1;             // |Σ area vectors| / area
// 3 volume / (area · D), below which the inside is uncertain; plates without holes are thin.
constexpr double kLeastVolume = 0.02, kLeastVolumeOfClosed = 1e-6;
constexpr std::uint32_t kNone = 0xffffffffu;

/// A connected surface, with the orientation of its first triangle.
struct Body {
    Eigen::AlignedBox3d box;
    Vector3d area_vectors = Vector3d::Zero();
    double area = 0, flipped_area = 0, volume = 0;  // twice, twice, six times
    std::size_t sides = 0, borders = 0;
    bool is_orientable = true, is_closed = false, is_flipped = false;
    std::vector<std::uint32_t> around = {};  // closed bodies that it lies in

    void add(const PreparedMesh& mesh, const Triangle& t, double sign) {
        const Vector3d vector = area_vector(mesh, t);
        area += vector.norm();
        if (sign < 0) flipped_area += vector.norm();
        area_vectors += sign * vector;
        volume += sign * mesh.positions[t[0]].dot(vector);
        sides += 3;
        for (const std::uint32_t v : t)
            box.extend(mesh.positions[v]);
    }

    void decide() {
        const double about_middle = volume - area_vectors.dot(box.center());
        const bool is_whole = borders == 0;
        is_closed = is_orientable &&
                    double(2 * borders) <= kMostBordersOfHoles * double(sides + borders) &&
                    area_vectors.norm() < kMostOpen * area &&
                    std::abs(about_middle) > (is_whole ? kLeastVolumeOfClosed : kLeastVolume) *
                                                 area * box.diagonal().norm();
        volume = about_middle;
        is_flipped = is_closed ? volume < 0 : is_orientable && 2 * flipped_area > area;
    }
};

/// Finds which closed bodies lie in which: a ray from one crosses those around it an odd number of
/// times.
class Nesting {
public:
    Nesting(const PreparedMesh& mesh, const std::vector<std::uint32_t>& body_of,
            std::vector<Body>& bodies)
        : mesh_(mesh), body_of_(body_of), bodies_(bodies) {}

    void find() {
        using Box = BoxTree<3>::Box;
        const auto triangles =
            BoxTree<3>::along_curve(mesh_.triangles.size(), local_box(), [&](std::uint32_t t) {
                Box box;
                if (!bodies_[body_of_[t]].is_closed) return box;
                for (const std::uint32_t v : mesh_.triangles[t])
                    box.extend(mesh_.positions[v].cast<float>().eval());
                return box;
            });
        std::vector<std::uint32_t> first(bodies_.size());
        for (std::size_t t = mesh_.triangles.size(); t-- > 0;)
            first[body_of_[t]] = std::uint32_t(t);
        in_parallel(bodies_.size(), [&](std::size_t b) {
            Body& body = bodies_[b];
            if (!body.is_closed) return;
            const Triangle& t = mesh_.triangles[first[b]];
            const auto& p = mesh_.positions;
            const Vector3d from = (p[t[0]] + p[t[1]] + p[t[2]]) / 3;
            Box ray(from.cast<float>().eval());  // along x, to beyond the mesh
            ray.max().x() = 2;
            std::map<std::uint32_t, int> crossings;
            triangles.visit(ray, [&](std::uint32_t other) {
                const std::uint32_t outer = body_of_[other];
                if (outer != b && bodies_[outer].box.contains(body.box) && is_pierced(other, from))
                    ++crossings[outer];
                return true;
            });
            for (const auto& [outer, count] : crossings)
                if (count % 2 == 1) body.around.push_back(outer);
        });
    }

private:
    /// Consistent at sides: a ray that meets one passes exactly one of its triangles.
    bool is_pierced(std::uint32_t triangle, const Vector3d& from) const {
        const Triangle& t = mesh_.triangles[triangle];
        const Vector3d corners[3] = {mesh_.positions[t[0]], mesh_.positions[t[1]],
                                     mesh_.positions[t[2]]};
        const auto is_left = [&](const Vector3d& a, const Vector3d& b) {
            const bool is_first = a.y() != b.y() ? a.y() < b.y() : a.z() < b.z();
            const Vector3d &p = is_first ? a : b, &q = is_first ? b : a;
            const double turn =
                (q.y() - p.y()) * (from.z() - p.z()) - (q.z() - p.z()) * (from.y() - p.y());
            return (turn >= 0) == is_first;
        };
        const bool left = is_left(corners[0], corners[1]);
        if (is_left(corners[1], corners[2]) != left || is_left(corners[2], corners[0]) != left)
            return false;
        const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        return normal.dot(corners[0] - from) * normal.x() > 0;
    }

    const PreparedMesh& mesh_;
    const std::vector<std::uint32_t>& body_of_;
    std::vector<Body>& bodies_;
};

/// From the outside inwards: bodies within solid matter are turned with it.
void flip_together(std::vector<Body>& bodies) {
    std::vector<std::uint32_t> order(bodies.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto depth = [&](std::uint32_t b) { return bodies[b].around.size(); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return depth(a) < depth(b); });
    for (const std::uint32_t b : order) {
        const std::vector<std::uint32_t>& around = bodies[b].around;
        if (around.empty()) continue;
        const Body& next = bodies[*std::max_element(
            around.begin(), around.end(),
            [&](std::uint32_t a, std::uint32_t c) { return depth(a) < depth(c); })];
        if ((next.volume > 0) != next.is_flipped) bodies[b].is_flipped = next.is_flipped;
    }
}

class Orienting {
public:
    explicit Orienting(PreparedMesh& mesh)
        : mesh_(mesh),
          table_(sides_of(mesh)),
          body_of_(mesh.triangles.size(), kNone),
          is_flipped_(mesh.triangles.size(), 0) {}

    void run() {
        find_bodies();
        measure_bodies();
        for (Body& body : bodies_)
            body.decide();
        if (bodies_.size() > 1 && std::any_of(bodies_.begin(), bodies_.end(), [](const Body& body) {
                return body.is_closed && body.is_flipped;
            })) {
            Nesting(mesh_, body_of_, bodies_).find();
            flip_together(bodies_);
        }
        flip();
    }

private:
    /// Whether two triangles disagree about the outside at their edge.
    bool is_opposed(std::uint32_t side, std::uint32_t other) const {
        return begin_of(mesh_.triangles, side) == begin_of(mesh_.triangles, other);
    }

    /// Bodies: triangles that are connected across edges of two.
    void find_bodies() {
        std::vector<std::uint32_t> open;
        for (std::uint32_t first = 0; first < body_of_.size(); ++first) {
            if (body_of_[first] != kNone) continue;
            body_of_[first] = std::uint32_t(bodies_.size());
            bodies_.emplace_back();
            open = {first};
            while (!open.empty()) {
                const std::uint32_t triangle = open.back();
                open.pop_back();
                for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
                    if (table_.has_neighbour(side)) reach_across(side, open);
                    bodies_.back().borders += table_.across(side) == CornerTable::kBorder;
                }
            }
        }
    }

    void reach_across(std::uint32_t side, std::vector<std::uint32_t>& open) {
        const std::uint32_t other = table_.across(side), here = side / 3, there = other / 3;
        const bool is_known = body_of_[there] != kNone;
        if ((is_known && other < side) || is_same(here, there)) return;  // once an edge is enough
        const bool is_flipped = bool(is_flipped_[here]) != is_opposed(side, other);
        if (!is_known) {
            body_of_[there] = body_of_[here];
            is_flipped_[there] = is_flipped;
            open.push_back(there);
        } else if (bool(is_flipped_[there]) != is_flipped) {
            bodies_[body_of_[here]].is_orientable = false;
        }
    }

    /// Whether neighbours have the same third corner.
    bool is_same(std::uint32_t a, std::uint32_t b) const {
        const Triangle &t = mesh_.triangles[a], &u = mesh_.triangles[b];
        return t[0] + t[1] + t[2] == u[0] + u[1] + u[2];
    }

    void measure_bodies() {
        for (std::uint32_t t = 0; t < body_of_.size(); ++t)
            bodies_[body_of_[t]].add(mesh_, mesh_.triangles[t], is_flipped_[t] ? -1 : 1);
        std::size_t borders = 0;
        for (const Body& body : bodies_)
            borders += body.borders;
        if (bodies_.size() > 1)  // a single open surface has borders by intent
            mesh_.report.border_share = double(borders) / double(table_.edge_count());
    }

    bool is_to_flip(std::uint32_t t) const {
        const Body& body = bodies_[body_of_[t]];
        return body.is_orientable && body.is_flipped != bool(is_flipped_[t]);
    }

    void flip() {
        const double opposed = sum_of(table_.side_count(), [&](std::size_t i) {
            const auto side = std::uint32_t(i), other = table_.across(side);
            return table_.has_neighbour(side) && side < other &&
                   is_opposed(side, other) == (is_to_flip(side / 3) == is_to_flip(other / 3));
        });
        std::size_t flipped = 0;
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
            if (is_to_flip(t)) std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]), ++flipped;
        mesh_.report.opposed_share = opposed / double(table_.edge_count());
        mesh_.report.flipped_triangles = flipped;
        if (flipped > 0) mesh_.sides.reset();
    }

    PreparedMesh& mesh_;
    const CornerTable& table_;
    std::vector<Body> bodies_;
    std::vector<std::uint32_t> body_of_;    // by triangle
    std::vector<std::uint8_t> is_flipped_;  // against the first triangle of its body
};

}  // namespace

void orient(PreparedMesh& mesh) {
    Orienting(mesh).run();
}

}  // namespace laplacian_lines
