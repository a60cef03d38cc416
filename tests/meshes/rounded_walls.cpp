// SPDX-License-Identifier: GPL-3.0-or-later
#include "rounded_walls.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace test_meshes {
namespace {

using Eigen::Vector3d;

/// {y : n·y <= −a} left by walls that moved inwards by a radius, from a point at y = 0, without
/// walls too far to matter.
struct HalfSpaces {
    std::vector<Vector3d> n;
    std::vector<double> a;

    HalfSpaces(const std::vector<Wall>& walls, double radius) {
        for (const Wall& wall : walls)
            if (wall.distance > -2 * radius) {
                n.push_back(wall.normal);
                a.push_back(wall.distance + radius);
            }
    }
    bool hold(const Vector3d& y) const {
        for (std::size_t i = 0; i < n.size(); ++i)
            if (n[i].dot(y) + a[i] > 1e-12) return false;
        return true;
    }
};

/// The nearest point to 0 where the bounds of some half spaces meet, if all of them push.
template <int Count>
std::optional<Vector3d> meeting(const HalfSpaces& spaces,
                                const std::array<std::size_t, Count>& chosen) {
    Eigen::Matrix<double, 3, Count> n;
    Eigen::Matrix<double, Count, 1> a;
    for (int k = 0; k < Count; ++k) {
        n.col(k) = spaces.n[chosen[std::size_t(k)]];
        a[k] = spaces.a[chosen[std::size_t(k)]];
    }
    const Eigen::Matrix<double, Count, Count> gram = n.transpose() * n;
    if (gram.determinant() < 1e-10) return std::nullopt;  // parallel
    const Eigen::Matrix<double, Count, 1> push = gram.inverse() * a;
    if (push.minCoeff() < 0) return std::nullopt;
    const Vector3d y = -n * push;
    if (!spaces.hold(y)) return std::nullopt;
    return y;
}

/// The nearest point to 0 in all half spaces: on one, two or three bounds.
std::optional<Vector3d> nearest_point(const HalfSpaces& spaces) {
    const std::size_t count = spaces.n.size();
    for (std::size_t i = 0; i < count; ++i)
        if (const auto y = meeting<1>(spaces, {i})) return y;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (const auto y = meeting<2>(spaces, {i, j})) return y;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (std::size_t k = 0; k < j; ++k)
                if (const auto y = meeting<3>(spaces, {i, j, k})) return y;
    return std::nullopt;
}

}  // namespace

Wall rounded_intersection(const std::vector<Wall>& walls, double radius) {
    const Wall outermost =
        *std::max_element(walls.begin(), walls.end(),
                          [](const Wall& a, const Wall& b) { return a.distance < b.distance; });
    if (radius <= 0 || outermost.distance <= -radius) return outermost;
    const std::optional<Vector3d> y = nearest_point(HalfSpaces(walls, radius));
    if (!y || y->norm() == 0) return outermost;
    return {y->norm() - radius, -y->normalized()};
}

Wall rounded_union(const std::vector<Wall>& walls, double radius) {
    std::vector<Wall> flipped;
    for (const Wall& wall : walls)
        flipped.push_back(wall.flipped());
    return rounded_intersection(flipped, radius).flipped();
}

Eigen::Vector3d onto_surface(const Solid& solid, Eigen::Vector3d p) {
    for (int step = 0; step < 20; ++step) {
        const Wall wall = solid(p);
        p -= wall.distance * wall.normal;
        if (std::abs(wall.distance) < 1e-13) break;
    }
    return p;
}

}  // namespace test_meshes
