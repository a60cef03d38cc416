// SPDX-License-Identifier: GPL-3.0-or-later
#include "thrown_vessel.h"

#include <algorithm>
#include <cmath>

#include "generators.h"

namespace test_meshes {
namespace {

using Eigen::Vector2d;

constexpr double kTau = 6.283185307179586;

/// Corners of a smooth profile; double ones are sharp.
const std::vector<Vector2d> kCorners = {
    {0, 5},    {0, 5},    {20, 5},   {34, 4},   {38, 0},   {38, 0},   {46, 0},
    {46, 0},   {49, 8},   {62, 32},  {80, 68},  {90, 102}, {86, 132}, {70, 158},
    {56, 172}, {52, 180}, {55, 190}, {65, 196}, {70, 197}, {71, 199}, {67, 200},
    {58, 196}, {49, 188}, {46, 180}, {50, 169}, {64, 154}, {79, 130}, {83, 102},
    {73, 70},  {55, 35},  {38, 15},  {20, 12},  {0, 11},   {0, 11}};

/// Catmull-Rom.
Vector2d on_curve(double at) {
    const auto last = std::ptrdiff_t(kCorners.size()) - 1;
    const std::ptrdiff_t i = std::min(std::ptrdiff_t(at), last - 1);
    const auto corner = [&](std::ptrdiff_t k) {
        return kCorners[std::size_t(std::min(std::max<std::ptrdiff_t>(k, 0), last))];
    };
    const double t = at - double(i);
    const Vector2d a = corner(i - 1), b = corner(i), c = corner(i + 1), d = corner(i + 2);
    if (b == c) return b;
    // A double corner has no direction.
    const Vector2d from = a == b ? Vector2d(c - b) : Vector2d((c - a) / 2);
    const Vector2d to = c == d ? Vector2d(c - b) : Vector2d((d - b) / 2);
    const double s = 1 - t;
    return s * s * (1 + 2 * t) * b + s * s * t * from + t * t * (3 - 2 * t) * c - t * t * s * to;
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

std::vector<Vector2d> vessel_profile(int points) {
    constexpr int kFine = 20000;
    std::vector<Vector2d> fine;
    std::vector<double> lengths = {0};
    for (int i = 0; i <= kFine; ++i) {
        fine.push_back(on_curve(double(kCorners.size() - 1) * i / kFine));
        if (i > 0)
            lengths.push_back(lengths.back() +
                              (fine[std::size_t(i)] - fine[std::size_t(i - 1)]).norm());
    }
    std::vector<Vector2d> profile;
    std::size_t k = 0;
    for (int i = 0; i < points; ++i) {
        const double at = lengths.back() * i / (points - 1);
        while (k + 1 < lengths.size() && lengths[k] < at)
            ++k;
        profile.push_back(fine[k]);
    }
    return profile;
}

laplacian_lines::TriangleMesh thrown_vessel(const VesselShape& shape) {
    const std::vector<Vector2d> profile = vessel_profile(shape.rings);
    const auto rim = std::max_element(profile.begin(), profile.end(),
                                      [](auto& a, auto& b) { return a.y() < b.y(); });
    return grid_mesh({shape.columns, shape.rings - 1, true, false}, [&](double u, double v) {
        const auto ring = profile.begin() + std::lround(v * (shape.rings - 1));
        const double angle = kTau * u;
        const double radius = ring->x() + shape.relief * relief_at(*ring, angle, ring > rim);
        return Eigen::Vector3d(radius * std::cos(angle), ring->y(), radius * std::sin(angle));
    });
}

}  // namespace test_meshes
