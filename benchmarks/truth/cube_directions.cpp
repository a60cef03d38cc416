// SPDX-License-Identifier: GPL-3.0-or-later
#include "cube_directions.h"

#include <Eigen/Geometry>
#include <array>
#include <set>

namespace benchmarks {
namespace {

constexpr double degree = M_PI / 180;

PlaneFrame frame_towards(const Eigen::Vector3d& direction) {
    const Eigen::Vector3d viewer = direction.normalized();
    const Eigen::Vector3d up =
        std::abs(viewer.z()) < 0.99 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
    const Eigen::Vector3d right = up.cross(viewer).normalized();
    return {right, viewer.cross(right), viewer};
}

/// The viewer goes aside by the angle, in a direction that no edge of a form has.
PlaneFrame turned_aside(const PlaneFrame& frame, double angle) {
    const Eigen::Vector3d axis = std::cos(0.6) * frame.right + std::sin(0.6) * frame.up;
    const Eigen::AngleAxisd turn(angle, axis.normalized());
    return {turn * frame.right, turn * frame.up, turn * frame.viewer};
}

PlaneFrame frame_of_angles(double azimuth, double elevation) {
    const double a = azimuth * degree, e = elevation * degree;
    return frame_towards({std::cos(e) * std::sin(a), -std::cos(e) * std::cos(a), std::sin(e)});
}

}  // namespace

std::vector<NamedFrame> all_directions() {
    std::vector<NamedFrame> found;
    for (int i = 1; i < 27; ++i) {
        const std::array<int, 3> signs = {i / 9, i / 3 % 3, i % 3};
        std::string name;
        Eigen::Vector3d viewer;
        for (int axis = 0; axis < 3; ++axis) {
            const int sign = signs[std::size_t(axis)];
            name += "0+-"[sign];
            viewer[axis] = sign == 2 ? -1 : sign;
        }
        const PlaneFrame frame = frame_towards(viewer);
        found.push_back({name, frame});
        found.push_back({name + " by 1e-6", turned_aside(frame, 1e-6)});
        found.push_back({name + " by 1 degree", turned_aside(frame, degree)});
    }
    for (const auto& [azimuth, elevation] : {std::pair(23, 31), {-52, 17}, {117, 43}, {-149, -26}})
        found.push_back({std::to_string(azimuth) + "," + std::to_string(elevation),
                         frame_of_angles(azimuth, elevation)});
    return found;
}

std::vector<NamedFrame> few_directions() {
    const std::set<std::string> names = {
        "0-0", "+00",         "00+", "0-0 by 1e-6", "-00 by 1e-6", "0+0 by 1 degree",
        "+-0", "0-+ by 1e-6", "--+", "+++ by 1e-6", "23,31",       "-149,-26"};
    std::vector<NamedFrame> few;
    for (const NamedFrame& direction : all_directions())
        if (names.count(direction.name)) few.push_back(direction);
    return few;
}

}  // namespace benchmarks
