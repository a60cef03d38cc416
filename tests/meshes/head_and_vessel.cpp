// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace test_meshes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3i;

/// `height` at the centre, times exp(-1/2) at its half axes.
struct Blob {
    Vector3d centre, half_axes;
    double height;
    bool on_both_sides;

    double at(const Vector3d& p) const {
        return height * std::exp(-0.5 * (p - centre).cwiseQuotient(half_axes).squaredNorm());
    }
};

const Blob kBlobs[] = {
    {{0, 0.2, -0.1}, {0.55, 0.6, 0.65}, 1, false},          // skull
    {{0, -0.25, 0.1}, {0.36, 0.42, 0.42}, 0.7, false},      // jaw
    {{0, -0.7, -0.2}, {0.27, 0.25, 0.28}, 1.2, false},      // neck
    {{0, 0.06, 0.68}, {0.06, 0.2, 0.1}, 0.25, false},       // bridge of the nose
    {{0, -0.08, 0.74}, {0.09, 0.08, 0.1}, 0.3, false},      // its tip
    {{0.1, -0.12, 0.66}, {0.05, 0.05, 0.07}, 0.15, true},   // its wings
    {{0.2, 0.12, 0.6}, {0.1, 0.07, 0.12}, -0.3, true},      // sockets
    {{0.2, 0.1, 0.55}, {0.06, 0.05, 0.06}, 0.25, true},     // eyes
    {{0.2, 0.25, 0.6}, {0.14, 0.05, 0.08}, 0.15, true},     // brows
    {{0.27, -0.1, 0.48}, {0.11, 0.1, 0.12}, 0.12, true},    // cheeks
    {{0, -0.27, 0.6}, {0.13, 0.035, 0.08}, 0.16, false},    // upper lip
    {{0, -0.37, 0.58}, {0.11, 0.04, 0.08}, 0.18, false},    // lower lip
    {{0, -0.32, 0.64}, {0.14, 0.022, 0.08}, -0.18, false},  // mouth
    {{0, -0.57, 0.5}, {0.12, 0.07, 0.1}, 0.25, false},      // chin
    {{0.62, 0.06, -0.1}, {0.05, 0.17, 0.11}, 0.7, true},    // ears
    {{0.7, 0.07, -0.05}, {0.06, 0.1, 0.05}, -0.45, true},   // their hollows
};
constexpr double kLevel = 0.6;
constexpr double kHalfWidth = 1.1;

/// Below 0 inside.
double value_at(const Vector3d& p) {
    double sum = 0;
    for (const Blob& blob : kBlobs) {
        sum += blob.at(p);
        if (blob.on_both_sides) sum += blob.at(p.cwiseProduct(Vector3d(-1, 1, 1)));
    }
    return kLevel - sum;
}

/// Values of a cube's voxels, x first; inside is below 0.
struct Volume {
    Volume(int size, bool is_labels) : size(size) {
        for (int z = 0; z < size; ++z)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const double value = value_at(place(Vector3d(x, y, z)));
                    values.push_back(is_labels ? (value < 0 ? -0.5f : 0.5f) : float(value));
                }
    }
    std::size_t index(const Vector3i& voxel) const {
        return std::size_t(voxel.x() + size * (voxel.y() + size * voxel.z()));
    }
    Vector3d place(const Vector3d& voxel) const {
        return kHalfWidth * (2 / double(size - 1) * voxel - Vector3d::Ones());
    }
    const int size;
    std::vector<float> values;
};

/// Bit k of a corner's number is its coordinate along axis k.
Vector3i corner_place(int corner) {
    return {corner & 1, corner >> 1 & 1, corner >> 2 & 1};
}

// Corners of each face of a cell, counterclockwise from outside.
constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                              {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

class Cells {
public:
    explicit Cells(const Volume& volume) : volume_(volume) {
        Vector3i cell;
        for (cell.z() = 0; cell.z() + 1 < volume.size; ++cell.z())
            for (cell.y() = 0; cell.y() + 1 < volume.size; ++cell.y())
                for (cell.x() = 0; cell.x() + 1 < volume.size; ++cell.x())
                    add_cell(cell);
    }
    TriangleMesh mesh;

private:
    static constexpr int kNone = -1;

    bool is_inside(const Vector3i& voxel) const { return volume_.values[volume_.index(voxel)] < 0; }

    void add_cell(const Vector3i& cell) {
        std::array<bool, 8> inside;
        int count = 0;
        for (int c = 0; c < 8; ++c)
            count += inside[std::size_t(c)] = is_inside(cell + corner_place(c));
        if (count == 0 || count == 8) return;
        std::array<int, 64> next;
        follow_faces(inside, next);
        for (int crossing = 0; crossing < 64; ++crossing)
            if (next[std::size_t(crossing)] != kNone) add_polygon(cell, crossing, next);
    }

    /// A crossing is 8 times its inside corner plus the outside one. In each face, the line that
    /// leaves a crossing outwards goes around the inside corners before it.
    static void follow_faces(const std::array<bool, 8>& inside, std::array<int, 64>& next) {
        next.fill(kNone);
        for (const auto& face : kFaces)
            for (int k = 0; k < 4; ++k) {
                const auto corner = [&](int i) { return face[(k + i + 4) % 4]; };
                const auto in = [&](int i) { return inside[std::size_t(corner(i))]; };
                if (!in(0) || in(1)) continue;
                int first = 0;
                while (in(first - 1))
                    --first;
                next[std::size_t(8 * corner(0) + corner(1))] =
                    8 * corner(first) + corner(first - 1);
            }
    }

    /// Removes its crossings from the list.
    void add_polygon(const Vector3i& cell, int crossing, std::array<int, 64>& next) {
        const std::uint32_t first = vertex(cell, crossing);
        std::uint32_t last = 0;
        for (int count = 0; crossing != kNone; ++count) {
            const std::uint32_t v = vertex(cell, crossing);
            if (count >= 2) mesh.triangles.push_back({first, v, last});
            last = v;
            const int after = next[std::size_t(crossing)];
            next[std::size_t(crossing)] = kNone;
            crossing = next[std::size_t(after)] == kNone ? kNone : after;
        }
    }

    std::uint32_t vertex(const Vector3i& cell, int crossing) {
        const Vector3i a = cell + corner_place(crossing / 8), b = cell + corner_place(crossing % 8);
        const std::size_t ia = volume_.index(a), ib = volume_.index(b);
        const std::uint64_t low = std::min(ia, ib),
                            axis = (a - b).cwiseAbs().dot(Vector3i(0, 1, 2));
        const auto [found, is_new] =
            vertices_.try_emplace(3 * low + axis, std::uint32_t(mesh.positions.size()));
        if (is_new) {
            const double fa = double(volume_.values[ia]), fb = double(volume_.values[ib]);
            const Vector3d place = a.cast<double>() + fa / (fa - fb) * (b - a).cast<double>();
            mesh.positions.push_back(volume_.place(place));
        }
        return found->second;
    }

    const Volume& volume_;
    std::unordered_map<std::uint64_t, std::uint32_t> vertices_;  // by edge of the grid
};

constexpr double kTau = 6.283185307179586;

constexpr double kHeight = 200, kWall = 6, kFoot = 5, kFloor = kFoot + kWall;  // mm

double outer_radius(double height) {
    return 70 + 20 * std::sin(kTau * height / 160 - 1.2);
}

/// `t`: 0..1, nearly as the way along it.
Vector2d on_profile(double t) {
    const double at = 560 * t;
    if (at < 50) return {at / 50 * outer_radius(0), kFoot * (1 - std::pow(at / 50, 4))};
    if (at < 280) return {outer_radius((at - 50) / 230 * kHeight), (at - 50) / 230 * kHeight};
    if (at < 290) return {outer_radius(kHeight) - (at - 280) / 10 * kWall, kHeight};
    if (at > 510) return {(560 - at) / 50 * (outer_radius(kFloor) - kWall), kFloor};
    const double height = kHeight - (at - 290) / 220 * (kHeight - kFloor);
    return {outer_radius(height) - kWall, height};
}

double bump(double x) {
    return std::exp(-x * x / 2);
}

/// Relief, mm.
double relief_at(const Vector2d& p, double angle, bool is_inside) {
    if (is_inside) return p.x() > 20 ? 0.35 * std::sin(kTau * (p.y() / 9 + angle / kTau)) : 0;
    if (p.y() < 90 || p.y() > 160) return 0;
    const double wave = 137 + 4 * std::sin(10 * angle);
    return -0.9 *
           (bump((p.y() - 128) / 0.9) + bump((p.y() - 146) / 0.9) + bump((p.y() - wave) / 0.8));
}

}  // namespace

TriangleMesh smooth_head(int size) {
    return std::move(Cells(Volume(size, false)).mesh);
}

TriangleMesh terraced_head(int size) {
    return std::move(Cells(Volume(size, true)).mesh);
}

std::vector<Vector2d> vessel_profile(int points) {
    std::vector<Vector2d> profile;
    for (int i = 0; i < points; ++i)
        profile.push_back(on_profile(double(i) / (points - 1)));
    return profile;
}

TriangleMesh thrown_vessel(const VesselShape& shape) {
    const std::vector<Vector2d> profile = vessel_profile(shape.rings);
    const auto rim = std::max_element(profile.begin(), profile.end(),
                                      [](auto& a, auto& b) { return a.y() < b.y(); });
    return grid_mesh({shape.columns, shape.rings - 1, true, false}, [&](double u, double v) {
        const auto ring = profile.begin() + std::lround(v * (shape.rings - 1));
        const double angle = -kTau * u;
        const double radius = ring->x() + shape.relief * relief_at(*ring, angle, ring > rim);
        return Eigen::Vector3d(radius * std::cos(angle), ring->y(), radius * std::sin(angle));
    });
}

}  // namespace test_meshes
