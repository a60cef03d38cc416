// SPDX-License-Identifier: GPL-3.0-or-later
#include "machined_part.h"

#include <cmath>

namespace test_meshes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTurn = 6.283185307179586;

/// Beyond {p[axis] = at}; outside is towards `side`.
Wall half_space(const Vector3d& p, int axis, double at, double side) {
    return {side * (p[axis] - at), side * Vector3d::Unit(axis)};
}

/// Outside an upright cylinder.
Wall around_hole(const Vector3d& p) {
    const Vector3d across(p.x() - part::kHoleX, p.y(), 0);
    return across.norm() > 0 ? Wall{part::kHoleRadius - across.norm(), -across.normalized()}
                             : Wall{part::kHoleRadius, Vector3d::UnitX()};
}

/// Cut into pieces, with what is on both sides.
class Edges {
public:
    explicit Edges(const Solid& solid) : solid_(solid) {}

    void add_line(const Vector3d& a, const Vector3d& b, const Vector3d& normal, bool convex) {
        add([&](double t) { return Vector3d(a + t * (b - a)); }, [&](double) { return normal; },
            (b - a).norm(), convex);
    }
    void add_rim(double z, double up) {
        const auto around = [](double t) {
            return Vector3d(std::cos(kTurn * t), std::sin(kTurn * t), 0);
        };
        const Vector3d middle(part::kHoleX, 0, z);
        add([&](double t) { return Vector3d(middle + part::kHoleRadius * around(t)); },
            [&](double t) { return Vector3d(up * Vector3d::UnitZ() - around(t)); },
            kTurn * part::kHoleRadius, true);
    }
    std::vector<ArrisPiece> pieces;

private:
    template <class Place, class Normal>
    void add(const Place& place, const Normal& normal, double length, bool convex) {
        const int count = int(std::ceil(length / (0.005 * MachinedPart::diagonal())));
        for (int i = 0; i < count; ++i) {
            const double from = double(i) / count, to = double(i + 1) / count;
            pieces.push_back({onto_surface(solid_, place(from)), onto_surface(solid_, place(to)),
                              90, normal((from + to) / 2).normalized(), convex});
        }
    }
    const Solid& solid_;
};

Vector3d at_depth(const Vector2d& p, double y) {
    return {p.x(), y, p.y()};
}

Vector2d outward(const Vector2d& along) {
    return Vector2d(along.y(), -along.x()).normalized();
}

}  // namespace

MachinedPart::MachinedPart(double fillet_radius) : radius_(fillet_radius * diagonal()) {}

double MachinedPart::diagonal() {
    return 2 * Vector3d(part::kLength, part::kDepth, part::kHeight).norm();
}

Wall MachinedPart::wall(const Vector3d& p) const {
    using namespace part;
    const Wall beside_slot =
        rounded_union({half_space(p, 0, kSlotLeft, 1), half_space(p, 0, kSlotRight, -1),
                       half_space(p, 2, kSlotBottom, 1)},
                      radius_);
    const Wall beside_step =
        rounded_union({half_space(p, 0, kStepLeft, 1), half_space(p, 2, kStepTop, 1)}, radius_);
    return rounded_intersection(
        {half_space(p, 0, kLength, 1), half_space(p, 0, -kLength, -1), half_space(p, 1, kDepth, 1),
         half_space(p, 1, -kDepth, -1), half_space(p, 2, kHeight, 1),
         half_space(p, 2, -kHeight, -1), beside_slot, beside_step, around_hole(p)},
        radius_);
}

laplacian_lines::TriangleMesh MachinedPart::mesh(double edge) const {
    const Vector3d corner(part::kLength, part::kDepth, part::kHeight);
    const Solid solid = [this](const Vector3d& p) { return wall(p); };
    return surface_net(solid, {-corner, corner}, edge * diagonal());
}

std::vector<ArrisPiece> MachinedPart::arrises() const {
    const Solid solid = [this](const Vector3d& p) { return wall(p); };
    Edges edges(solid);
    const std::vector<Vector2d> outline = part::profile();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d p = outline[i], next = outline[(i + 1) % outline.size()];
        const Vector2d before = p - outline[(i + outline.size() - 1) % outline.size()];
        const Vector2d after = next - p;
        edges.add_line(at_depth(p, -part::kDepth), at_depth(p, part::kDepth),
                       at_depth(outward(before) + outward(after), 0),
                       before.x() * after.y() - before.y() * after.x() > 0);
        for (const double side : {-1.0, 1.0})
            edges.add_line(at_depth(p, side * part::kDepth), at_depth(next, side * part::kDepth),
                           at_depth(outward(after), side), true);
    }
    edges.add_rim(part::kStepTop, 1);
    edges.add_rim(-part::kHeight, -1);
    return edges.pieces;
}

}  // namespace test_meshes
