// SPDX-License-Identifier: GPL-3.0-or-later
#include "flaked_stone.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "generators.h"
#include "random_unit.h"

namespace test_meshes {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
// In units of the body.
constexpr double kRippleLength = 0.12, kRippleFading = 0.6;

/// The i-th of `count` evenly spread directions, by the golden section.
Vector3d spread_direction(int i, int count) {
    const double z = 1 - (2 * i + 1.0) / count, turn = i * kPi * (3 - std::sqrt(5.0));
    const double ring = std::sqrt(1 - z * z);
    return {ring * std::cos(turn), ring * std::sin(turn), z};
}

Vector3d moved(std::mt19937& random, const Vector3d& direction, double most) {
    const double x = signed_unit(random), y = signed_unit(random), z = signed_unit(random);
    return (direction + most * Vector3d(x, y, z)).normalized();
}

/// A zero between `low`, f < 0, and `high`, f >= 0, by false position with halved weights.
template <class Function>
double find_zero(const Function& f, double low, double high) {
    double f_low = f(low), f_high = f(high);
    int stayed = 0;
    for (int step = 0; step < 100 && high - low > 1e-12; ++step) {
        const double x = low + (high - low) * f_low / (f_low - f_high), value = f(x);
        if (std::abs(value) < 1e-14) return x;
        if (value < 0) {
            low = x;
            f_low = value;
            if (stayed == 1) f_high /= 2;
            stayed = 1;
        } else {
            high = x;
            f_high = value;
            if (stayed == -1) f_low /= 2;
            stayed = -1;
        }
    }
    return (low + high) / 2;
}

}  // namespace

FlakedStone::FlakedStone(const StoneShape& shape) : half_axes_(shape.half_axes) {
    std::mt19937 random(shape.seed);
    const Vector3d axis = moved(random, Vector3d::Zero(), 1);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(between(random, 0, kPi), axis).toRotationMatrix();
    const double ripple = std::tan(shape.ripple_angle * kPi / 180) * kRippleLength / (2 * kPi);
    for (int i = 0; i < shape.scars; ++i) {
        const Vector3d direction = turn * spread_direction(i, shape.scars);
        scars_.push_back(random_scar(random, moved(random, direction, 0.2)));
        if (i % 3 == 0) scars_.back().ripple = ripple;
    }
    Eigen::AlignedBox3d box;
    for (const Vector3d& direction : icosphere(4).positions)
        box.extend(sharp_surface(direction));
    diagonal_ = box.diagonal().norm();
    edge_radius_ = shape.edge_radius * diagonal_;
}

/// About perpendicular to the body; so large that rays graze its sphere outside the body.
FlakedStone::Scar FlakedStone::random_scar(std::mt19937& random, const Vector3d& direction) const {
    const Vector3d on_body = direction / direction.cwiseQuotient(half_axes_).norm();
    const Vector3d up = moved(random, body_wall(on_body).normal, 0.15);
    const Vector3d deepest = on_body * between(random, 0.8, 0.96);
    const double reach = 1.1 * half_axes_.x();
    const double least = (reach * reach - deepest.squaredNorm()) / (2 * deepest.dot(up));
    Scar scar;
    scar.radius = std::max(least, between(random, 1.2, 3));
    scar.centre = deepest + scar.radius * up;
    scar.percussion = deepest + 0.3 * up.cross(moved(random, direction, 1)).normalized();
    return scar;
}

Wall FlakedStone::body_wall(const Vector3d& p) const {
    const Vector3d scaled = p.cwiseQuotient(half_axes_);
    const Vector3d gradient = scaled.cwiseQuotient(half_axes_) / scaled.norm();
    return {(scaled.norm() - 1) / gradient.norm(), gradient.normalized()};
}

Wall FlakedStone::scar_wall(const Scar& scar, const Vector3d& p) {
    const Vector3d in = scar.centre - p;
    const double distance = in.norm();
    if (scar.ripple == 0) return {scar.radius - distance, in / distance};
    const Vector3d away = p - scar.percussion;
    const double s = away.norm(), phase = 2 * kPi * s / kRippleLength;
    const double height = scar.ripple * std::exp(-s / kRippleFading);
    const double slope =
        -height * (std::cos(phase) / kRippleFading + std::sin(phase) * 2 * kPi / kRippleLength);
    const Vector3d gradient = in / distance + slope / s * away;
    return {(scar.radius - distance + height * std::cos(phase)) / gradient.norm(),
            gradient.normalized()};
}

Wall FlakedStone::face_wall(int face, const Vector3d& p) const {
    return face == 0 ? body_wall(p) : scar_wall(scars_[std::size_t(face) - 1], p);
}

std::vector<Wall> FlakedStone::walls(const Vector3d& p) const {
    std::vector<Wall> all = {body_wall(p)};
    for (const Scar& scar : scars_)
        all.push_back(scar_wall(scar, p));
    return all;
}

int FlakedStone::outermost_face(const Vector3d& p) const {
    int outermost = 0;
    double most = body_wall(p).distance;
    for (std::size_t i = 0; i < scars_.size(); ++i)
        if (const double distance = scar_wall(scars_[i], p).distance; distance > most) {
            most = distance;
            outermost = int(i) + 1;
        }
    return outermost;
}

Wall FlakedStone::wall(const Vector3d& p) const {
    return rounded_intersection(walls(p), edge_radius_);
}

Vector3d FlakedStone::sharp_surface(const Vector3d& direction) const {
    const auto outside = [&](double t) {
        const Vector3d p = t * direction;
        return face_wall(outermost_face(p), p).distance;
    };
    const double on_body = 1 / direction.cwiseQuotient(half_axes_).norm();
    return find_zero(outside, 0.1 * on_body, on_body * (1 + 1e-9)) * direction;
}

int FlakedStone::face(const Vector3d& direction) const {
    return outermost_face(sharp_surface(direction));
}

Vector3d FlakedStone::surface(const Vector3d& direction) const {
    const auto outside = [&](double t) { return wall(t * direction).distance; };
    const double sharp = sharp_surface(direction).norm();
    return find_zero(outside, 0.5 * sharp, sharp * (1 + 1e-9)) * direction;
}

TriangleMesh FlakedStone::mesh(int level, double jitter) const {
    TriangleMesh mesh = icosphere(level);
    std::mt19937 random(7);
    const double edge = 1.1 / (1 << level);
    for (Vector3d& p : mesh.positions)
        p = surface(moved(random, p, jitter * edge));
    return mesh;
}

}  // namespace test_meshes
