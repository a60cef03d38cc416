// SPDX-License-Identifier: GPL-3.0-or-later
// Undoing a subdivision, in which each triangle was cut in four at the middles of its edges: find a
// triangle whose corners are the middles of a larger one, made of it and its three neighbours; go
// on across the sides of these four. All triangles have to be used once, and no vertex may be a
// corner of one and a middle of another.
#include "mesh/midpoints.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>

#include "mesh/bounding_box.h"
#include "mesh/conforming.h"
#include "mesh/corner_table.h"
#include "mesh/equal_positions.h"
#include "mesh/prepared_mesh.h"

namespace laplacian_lines {
namespace {

// How far an edge's middle may be off along an axis: so much of the axis's largest coordinate, by
// rounding to floats twice, but at most so much of the mean edge, which is less than the bends of a
// smooth grid.
constexpr double kRounding = 5e-7, kMostOff = 1e-3;
// D, of the mean edge once undone: coarser triangles are the form's own.
constexpr double kLongestEdge = 0.025;

using Positions = std::vector<Eigen::Vector3d>;

/// A large triangle and its quarters: side k of the inner one is shared with quarter k, at corner
/// k.
struct Cut {
    Triangle corners;
    std::uint32_t inner;
    std::array<std::uint32_t, 3> quarters;
};

/// Joins quarters to large triangles, from one to the next across their sides.
class QuarterJoiner {
public:
    QuarterJoiner(const Positions& positions, const std::vector<Triangle>& triangles,
                  const Eigen::Vector3d& within)
        : positions_(positions),
          triangles_(triangles),
          within_(within),
          sides_(triangles, positions.size()),
          role_(positions.size(), Role::Unknown),
          is_done_(triangles.size(), 0) {}

    /// On flat parts, where several cuts are possible, triangles are skipped at first. They are
    /// reached from others: a vertex that is farthest to one side, as each surface has, is no
    /// middle.
    bool run() {
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            if (is_done_[i]) continue;
            const std::vector<Cut> cuts = cuts_with(i);
            if (cuts.empty() || (cuts.size() == 1 && !join_from(cuts[0].inner))) return false;
        }
        return 4 * joined_.size() == triangles_.size();
    }

    /// In the order of their first parts; each begins with the corner of its first quarter.
    std::vector<Triangle> large_triangles() const {
        std::vector<std::pair<std::uint32_t, Triangle>> large;
        for (const auto& [t, inner, quarters] : joined_) {
            const auto first = std::min_element(quarters.begin(), quarters.end());
            const auto k = std::size_t(first - quarters.begin());
            large.push_back({std::min(*first, inner), {t[k], t[(k + 1) % 3], t[(k + 2) % 3]}});
        }
        std::sort(large.begin(), large.end());
        std::vector<Triangle> triangles;
        for (const auto& [part, triangle] : large)
            triangles.push_back(triangle);
        return triangles;
    }

private:
    enum class Role : std::uint8_t { Unknown, Corner, Middle };

    /// The cuts that a triangle can belong to: it, or a neighbour, is the inner triangle.
    std::vector<Cut> cuts_with(std::uint32_t triangle) const {
        std::vector<Cut> cuts;
        const auto add = [&](std::uint32_t inner) {
            if (const std::optional<Cut> cut = cut_around(inner)) cuts.push_back(*cut);
        };
        add(triangle);
        for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side)
            if (sides_.has_neighbour(side)) add(sides_.across(side) / 3);
        return cuts;
    }

    bool is_middle(std::uint32_t middle, std::uint32_t a, std::uint32_t b) const {
        const Eigen::Vector3d off = (positions_[a] + positions_[b]) / 2 - positions_[middle];
        return a != b && (off.array().abs() <= within_.array()).all();
    }

    std::optional<Cut> cut_around(std::uint32_t inner) const {
        Cut cut{{}, inner, {}};
        for (std::uint32_t k = 0; k < 3; ++k) {
            if (!sides_.has_neighbour(3 * inner + k)) return std::nullopt;
            const std::uint32_t side = sides_.across(3 * inner + k);
            cut.quarters[k] = side / 3;
            cut.corners[k] = triangles_[side / 3][(side + 2) % 3];
        }
        for (std::size_t k = 0; k < 3; ++k)
            if (!is_middle(triangles_[inner][(k + 1) % 3], cut.corners[k],
                           cut.corners[(k + 1) % 3]))
                return std::nullopt;
        return cut;
    }

    bool join_from(std::uint32_t first) {
        std::vector<std::uint32_t> open = {first};
        while (!open.empty()) {
            const std::uint32_t inner = open.back();
            open.pop_back();
            if (is_done_[inner]) continue;
            const std::optional<Cut> cut = cut_around(inner);
            if (!cut || !join(*cut)) return false;
            for (std::size_t k = 0; k < 3; ++k)
                for (std::uint32_t side = 3 * cut->quarters[k]; side < 3 * cut->quarters[k] + 3;
                     ++side)
                    if (sides_.has_neighbour(side) && !is_done_[sides_.across(side) / 3] &&
                        !find_inner(sides_.across(side) / 3, cut->corners[k], open))
                        return false;
        }
        return true;
    }

    /// The inner triangle, across the side opposite a quarter's corner.
    bool find_inner(std::uint32_t quarter, std::uint32_t corner,
                    std::vector<std::uint32_t>& open) const {
        const Triangle& t = triangles_[quarter];
        const auto k = std::uint32_t(std::find(t.begin(), t.end(), corner) - t.begin());
        const std::uint32_t opposite = 3 * quarter + (k + 1) % 3;
        if (k == 3 || !sides_.has_neighbour(opposite)) return false;
        open.push_back(sides_.across(opposite) / 3);
        return true;
    }

    bool join(const Cut& cut) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t middle = triangles_[cut.inner][(k + 1) % 3];
            if (!set_role(middle, Role::Middle) || !set_role(cut.corners[k], Role::Corner) ||
                is_done_[cut.quarters[k]]++)
                return false;
        }
        joined_.push_back(cut);
        return is_done_[cut.inner]++ == 0;
    }

    bool set_role(std::uint32_t v, Role role) {
        if (role_[v] == Role::Unknown) role_[v] = role;
        return role_[v] == role;
    }

    const Positions& positions_;
    const std::vector<Triangle>& triangles_;
    const Eigen::Vector3d within_;  // by axis
    const CornerTable sides_;
    std::vector<Role> role_;             // by vertex
    std::vector<std::uint8_t> is_done_;  // by triangle
    std::vector<Cut> joined_;
};

bool undo_subdivision(const Positions& positions, double edge, std::vector<Triangle>& triangles) {
    if (triangles.size() % 4 != 0) return false;
    const Eigen::Vector3d within =
        (kRounding * largest_coordinates(bounding_box(positions, triangles)))
            .cwiseMin(kMostOff * edge);
    QuarterJoiner joiner(positions, triangles, within);
    if (!joiner.run()) return false;
    triangles = joiner.large_triangles();
    return true;
}

}  // namespace

void undo_subdivisions(TriangleMesh& mesh) {
    if (mesh.triangles.size() % 4 != 0) return;
    std::vector<Triangle> triangles =
        with_places(mesh.triangles, first_equal_positions(mesh.positions, mesh.triangles));
    if (!std::all_of(triangles.begin(), triangles.end(), has_three_corners)) return;
    const double longest =
        kLongestEdge * bounding_box(mesh.positions, triangles).diagonal().stableNorm();
    for (double edge = mean_edge(mesh.positions, triangles);
         2 * edge <= longest && undo_subdivision(mesh.positions, edge, triangles); edge *= 2)
        mesh.triangles = triangles;
}

}  // namespace laplacian_lines
