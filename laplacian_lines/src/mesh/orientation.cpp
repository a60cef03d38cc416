// SPDX-License-Identifier: GPL-3.0-or-later
// How triangles are turned outwards:
//  1. Neighbours across edges of two triangles are made to agree; what is connected so is a
//     component, with the orientation that most of its area has. One that cannot, such as a Möbius
//     strip, stays as it is, also where its triangles could agree.
//  2. A closed component, also one with holes, is turned as a whole if its volume is negative.
//  3. A closed component inside another one, found by a ray, is a cavity of it or a part within, so
//     it is turned exactly if that one was. What is inside a cavity decides for itself.
#include "mesh/orientation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
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
// 3 volume / (area · diagonal of its box), below which the inside is uncertain; plates without
// holes are thin.
constexpr double kLeastVolume = 0.02, kLeastVolumeOfClosed = 1e-6;
constexpr std::uint32_t kNone = 0xffffffffu;

/// A connected surface, with the orientation of most of its area.
struct Component {
    Eigen::AlignedBox3d box;
    Vector3d area_vectors = Vector3d::Zero();
    double area = 0, flipped_area = 0;   // twice
    double volume = 0;                   // six times, of the cones from the origin
    std::size_t sides = 0, borders = 0;  // borders: of one triangle, not of three or more
    bool is_orientable = true, is_closed = false;
    bool is_flipped = false;                 // to be turned as a whole
    std::vector<std::uint32_t> around = {};  // closed ones that it lies in

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

    /// Whether most of its area has the other orientation; then it takes that.
    bool follow_majority() {
        if (2 * flipped_area <= area) return false;
        area_vectors = -area_vectors;
        volume = -volume;
        return true;
    }

    void decide() {
        // now of the cones from the box's centre, which depends little on holes
        volume -= area_vectors.dot(box.center());
        const bool is_whole = borders == 0;
        is_closed = is_orientable &&
                    double(2 * borders) <= kMostBordersOfHoles * double(sides + borders) &&
                    area_vectors.norm() < kMostOpen * area &&
                    std::abs(volume) > (is_whole ? kLeastVolumeOfClosed : kLeastVolume) * area *
                                           box.diagonal().norm();
        is_flipped = is_closed && volume < 0;
    }
};

/// Whether the ray from a point towards +x pierces a triangle. Consistent at sides: a ray through a
/// side pierces one of its two triangles or, if both are seen on one side of it, both or none.
bool is_pierced(const PreparedMesh& mesh, const Triangle& t, const Vector3d& from) {
    const Vector3d corners[3] = {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
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

/// Finds which closed components lie in which: a ray from one crosses those around it an odd number
/// of times.
void find_nesting(const PreparedMesh& mesh, const std::vector<std::uint32_t>& component_of,
                  std::vector<Component>& components) {
    using Box = BoxTree<3>::Box;
    const auto triangles =
        BoxTree<3>::along_curve(mesh.triangles.size(), local_box(), [&](std::uint32_t t) {
            Box box;
            if (!components[component_of[t]].is_closed) return box;
            for (const std::uint32_t v : mesh.triangles[t])
                box.extend(mesh.positions[v].cast<float>().eval());
            return box;
        });
    std::vector<std::uint32_t> first(components.size());  // triangle of each
    for (std::size_t t = mesh.triangles.size(); t-- > 0;)
        first[component_of[t]] = std::uint32_t(t);
    in_parallel(components.size(), [&](std::size_t b) {
        Component& component = components[b];
        if (!component.is_closed) return;
        const auto [i, j, k] = mesh.triangles[first[b]];
        const Vector3d from = (mesh.positions[i] + mesh.positions[j] + mesh.positions[k]) / 3;
        Box ray(from.cast<float>().eval());  // along x, to beyond the mesh
        ray.max().x() = 2;
        std::map<std::uint32_t, int> crossings;
        triangles.visit(ray, [&](std::uint32_t other) {
            const std::uint32_t outer = component_of[other];
            if (outer != b && components[outer].box.contains(component.box) &&
                is_pierced(mesh, mesh.triangles[other], from))
                ++crossings[outer];
        });
        for (const auto& [outer, count] : crossings)
            if (count % 2 == 1) component.around.push_back(outer);
    });
}

/// From the outside inwards: what is within solid matter is turned with it.
void flip_together(std::vector<Component>& components) {
    std::vector<std::uint32_t> order = numbers_up_to(components.size());
    const auto depth = [&](std::uint32_t b) { return components[b].around.size(); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return depth(a) < depth(b); });
    for (const std::uint32_t b : order) {
        const std::vector<std::uint32_t>& around = components[b].around;
        if (around.empty()) continue;
        const Component& next = components[*std::max_element(
            around.begin(), around.end(),
            [&](std::uint32_t a, std::uint32_t c) { return depth(a) < depth(c); })];
        if ((next.volume > 0) != next.is_flipped) components[b].is_flipped = next.is_flipped;
    }
}

class Orienting {
public:
    explicit Orienting(PreparedMesh& mesh)
        : mesh_(mesh),
          table_(sides_of(mesh)),
          component_of_(mesh.triangles.size(), kNone),
          is_flipped_(mesh.triangles.size(), 0) {}

    void run() {
        find_components();
        measure_components();
        for (Component& component : components_)
            component.decide();
        if (components_.size() > 1 &&
            std::any_of(components_.begin(), components_.end(),
                        [](const Component& component) { return component.is_flipped; })) {
            find_nesting(mesh_, component_of_, components_);
            flip_together(components_);
        }
        flip();
    }

private:
    void find_components() {
        std::vector<std::uint32_t> open;
        for (std::uint32_t first = 0; first < component_of_.size(); ++first) {
            if (component_of_[first] != kNone) continue;
            component_of_[first] = std::uint32_t(components_.size());
            components_.emplace_back();
            open = {first};
            while (!open.empty()) {
                const std::uint32_t triangle = open.back();
                open.pop_back();
                for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
                    if (table_.has_neighbour(side)) reach_across(side, open);
                    components_.back().borders += table_.across(side) == CornerTable::kBorder;
                }
            }
        }
    }

    void reach_across(std::uint32_t side, std::vector<std::uint32_t>& open) {
        const std::uint32_t other = table_.across(side), here = side / 3, there = other / 3;
        const bool is_known = component_of_[there] != kNone;
        if ((is_known && other < side) || is_same(here, there)) return;  // once an edge is enough
        const bool is_flipped =
            bool(is_flipped_[here]) == have_one_orientation(mesh_.triangles, side, other);
        if (!is_known) {
            component_of_[there] = component_of_[here];
            is_flipped_[there] = is_flipped;
            open.push_back(there);
        } else if (bool(is_flipped_[there]) != is_flipped) {
            components_[component_of_[here]].is_orientable = false;
        }
    }

    /// Whether neighbours have one third corner: two sides of one face, which may well disagree.
    bool is_same(std::uint32_t a, std::uint32_t b) const {
        const Triangle &t = mesh_.triangles[a], &u = mesh_.triangles[b];
        return t[0] + t[1] + t[2] == u[0] + u[1] + u[2];
    }

    void measure_components() {
        for (std::uint32_t t = 0; t < component_of_.size(); ++t)
            components_[component_of_[t]].add(mesh_, mesh_.triangles[t], is_flipped_[t] ? -1 : 1);
        std::vector<std::uint8_t> follows;
        std::size_t borders = 0;
        for (Component& component : components_) {
            follows.push_back(component.follow_majority());
            borders += component.borders;
        }
        for (std::uint32_t t = 0; t < component_of_.size(); ++t)
            is_flipped_[t] ^= follows[component_of_[t]];
        if (components_.size() > 1)  // a single open surface has borders by intent
            mesh_.report.border_share = double(borders) / double(table_.edge_count());
    }

    bool is_to_flip(std::uint32_t t) const {
        const Component& component = components_[component_of_[t]];
        return component.is_orientable && component.is_flipped != bool(is_flipped_[t]);
    }

    /// Also reports the share of edges at which neighbours still disagree, as on a Möbius strip.
    void flip() {
        const double opposed = sum_of(table_.side_count(), [&](std::size_t i) {
            const auto side = std::uint32_t(i), other = table_.across(side);
            // they disagree after the flips as before if both or none of them flips
            return table_.has_neighbour(side) && side < other &&
                   have_one_orientation(mesh_.triangles, side, other) ==
                       (is_to_flip(side / 3) != is_to_flip(other / 3));
        });
        std::size_t flipped = 0;
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
            if (is_to_flip(t)) {
                std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
                ++flipped;
            }
        mesh_.report.opposed_share = opposed / double(table_.edge_count());
        mesh_.report.flipped_triangles = flipped;
        if (flipped > 0) mesh_.sides.reset();
    }

    PreparedMesh& mesh_;
    const CornerTable& table_;
    std::vector<Component> components_;
    std::vector<std::uint32_t> component_of_;  // by triangle
    std::vector<std::uint8_t> is_flipped_;     // against its component
};

}  // namespace

void orient(PreparedMesh& mesh) {
    Orienting(mesh).run();
}

}  // namespace laplacian_lines
