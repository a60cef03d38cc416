// SPDX-License-Identifier: GPL-3.0-or-later
#include "cube_directions.h"

#include <Eigen/Geometry>
#include <stdexcept>

#include "program.h"

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

/// Turns by the angle in a direction that no edge of a form has.
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

NamedFrame direction_named(const std::string& name) {
    const std::invalid_argument unknown("there is no direction " + name);
    if (const auto angles = split(name, ','); angles.size() == 2)
        return {name, frame_of_angles(parse_number(angles[0]), parse_number(angles[1]))};
    const std::string signs = name.substr(0, 3), aside = name.substr(signs.size());
    if (signs.size() < 3 || signs == "000" || signs.find_first_not_of("0+-") != signs.npos)
        throw unknown;
    Eigen::Vector3d viewer;
    for (int axis = 0; axis < 3; ++axis)
        viewer[axis] = signs[std::size_t(axis)] == '0'   ? 0
                       : signs[std::size_t(axis)] == '+' ? 1
                                                         : -1;
    const PlaneFrame frame = frame_towards(viewer);
    if (aside.empty()) return {name, frame};
    if (aside == " by 1e-6") return {name, turned_aside(frame, 1e-6)};
    if (aside == " by 1 degree") return {name, turned_aside(frame, degree)};
    throw unknown;
}

std::vector<NamedFrame> few_directions() {
    std::vector<NamedFrame> few;
    for (const char* name : {"0-0", "+00", "00+", "0-0 by 1e-6", "-00 by 1e-6", "0+0 by 1 degree",
                             "+-0", "0-+ by 1e-6", "--+", "+++ by 1e-6", "23,31", "-149,-26"})
        few.push_back(direction_named(name));
    return few;
}

}  // namespace benchmarks
