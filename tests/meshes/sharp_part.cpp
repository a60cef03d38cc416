// SPDX-License-Identifier: GPL-3.0-or-later
// The machined part with few triangles: columns of the profile, faces extruded along y, two rings
// around the hole.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "machined_part.h"

namespace test_meshes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::TriangleMesh;

constexpr double kTurn = 6.283185307179586;
constexpr int kSides = 32;  // of the hole

Vector3d rim(int i, double z) {
    const double angle = kTurn * (i % kSides) / kSides;
    return {part::kHoleX + part::kHoleRadius * std::cos(angle), part::kHoleRadius * std::sin(angle),
            z};
}

/// Between two heights of the profile.
struct Column {
    double left, right, top;
};
constexpr std::array<Column, 4> kColumns = {
    {{-part::kLength, part::kSlotLeft, part::kHeight},
     {part::kSlotLeft, part::kSlotRight, part::kSlotBottom},
     {part::kSlotRight, part::kStepLeft, part::kHeight},
     {part::kStepLeft, part::kLength, part::kStepTop}}};  // the hole is in the last one

class PartBuilder {
public:
    /// By (x, z) of its corners and of its neighbours' beside it.
    void add_ends(const std::vector<Vector2d>& outline) {
        std::vector<Vector3d> front, back;
        for (const Vector2d& p : outline) {
            front.push_back({p.x(), -part::kDepth, p.y()});
            back.push_back({p.x(), part::kDepth, p.y()});
        }
        std::reverse(back.begin(), back.end());
        add_polygon(front);
        add_polygon(back);
    }

    /// For a side of the profile, the solid to the left.
    void add_side(const Vector2d& p, const Vector2d& q) {
        constexpr double d = part::kDepth;
        add_polygon({{p.x(), -d, p.y()}, {p.x(), d, p.y()}, {q.x(), d, q.y()}, {q.x(), -d, q.y()}});
    }

    /// Between the hole and the last column's rectangle.
    void add_ring(double z, bool faces_up) {
        const auto [left, right, top] = kColumns.back();
        const Vector3d corners[4] = {{right, part::kDepth, z},
                                     {left, part::kDepth, z},
                                     {left, -part::kDepth, z},
                                     {right, -part::kDepth, z}};
        const auto add_facing = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
            faces_up ? add(a, b, c) : add(a, c, b);
        };
        for (int quarter = 0; quarter < 4; ++quarter) {
            const int first = quarter * kSides / 4, last = first + kSides / 4;
            for (int i = first; i < last; ++i)
                add_facing(rim(i, z), corners[quarter], rim(i + 1, z));
            add_facing(corners[quarter], corners[(quarter + 1) % 4], rim(last, z));
        }
    }

    void add_hole() {
        for (int i = 0; i < kSides; ++i)
            add_polygon({rim(i, -part::kHeight), rim(i, part::kStepTop), rim(i + 1, part::kStepTop),
                         rim(i + 1, -part::kHeight)});
    }

    TriangleMesh mesh;

private:
    /// Convex, counter-clockwise from outside, perhaps with corners within a side: a fan from the
    /// first corner that leaves no triangle without area.
    void add_polygon(std::vector<Vector3d> corners) {
        const auto is_flat = [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
            return (b - a).cross(c - a).norm() < 1e-9;
        };
        const auto makes_flat_fan = [&] {
            for (std::size_t i = 1; i + 1 < corners.size(); ++i)
                if (is_flat(corners[0], corners[i], corners[i + 1])) return true;
            return false;
        };
        for (std::size_t turns = 0; turns < corners.size() && makes_flat_fan(); ++turns)
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            add(corners[0], corners[i], corners[i + 1]);
    }
    void add(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        mesh.triangles.push_back({vertex(a), vertex(b), vertex(c)});
    }
    std::uint32_t vertex(const Vector3d& p) {
        const std::array<long, 3> place = {std::lround(1e6 * p.x()), std::lround(1e6 * p.y()),
                                           std::lround(1e6 * p.z())};
        const auto [found, is_new] =
            vertices_.try_emplace(place, std::uint32_t(mesh.positions.size()));
        if (is_new) mesh.positions.push_back(p);
        return found->second;
    }

    std::map<std::array<long, 3>, std::uint32_t> vertices_;
};

/// Counter-clockwise, with the tops of lower neighbours.
std::vector<Vector2d> outline_of(std::size_t i) {
    const Column& column = kColumns[i];
    std::vector<Vector2d> outline = {{column.left, -part::kHeight}, {column.right, -part::kHeight}};
    if (i + 1 < kColumns.size() && kColumns[i + 1].top < column.top)
        outline.push_back({column.right, kColumns[i + 1].top});
    outline.push_back({column.right, column.top});
    outline.push_back({column.left, column.top});
    if (i > 0 && kColumns[i - 1].top < column.top)
        outline.push_back({column.left, kColumns[i - 1].top});
    return outline;
}

}  // namespace

TriangleMesh sharp_part() {
    PartBuilder builder;
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
        builder.add_ends(outline_of(i));
        const auto [left, right, top] = kColumns[i];
        if (i + 1 == kColumns.size()) continue;
        builder.add_side({left, -part::kHeight}, {right, -part::kHeight});
        builder.add_side({right, top}, {left, top});
        builder.add_side({right, kColumns[i + 1].top}, {right, top});
    }
    builder.add_side({part::kLength, -part::kHeight}, {part::kLength, part::kStepTop});
    builder.add_side({-part::kLength, part::kHeight}, {-part::kLength, -part::kHeight});
    builder.add_ring(part::kStepTop, true);
    builder.add_ring(-part::kHeight, false);
    builder.add_hole();
    return builder.mesh;
}

}  // namespace test_meshes
