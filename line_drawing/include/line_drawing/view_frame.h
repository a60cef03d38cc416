// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace line_drawing {

/// Which axis of the mesh points up. The front view then looks along +y if up is z, and along −z if
/// up is x or y.
enum class UpAxis { X, Y, Z };

/// Which side of the object a view shows; Other: any direction.
enum class Side { Front, Back, Left, Right, Top, Bottom, Other };

/// A view: how the axes of the picture lie in mesh coordinates. Orthonormal,
/// right × up = towards_viewer.
struct ViewFrame {
    Side side = Side::Front;
    std::string name;  ///< for people, "Front" or "30°, 15°"
    Eigen::Vector3d right, up, towards_viewer;
    /// A vessel: left of its axis the section and what is behind it, right of it the outside.
    bool is_half_section = false;
    /// Where the eye of a perspective view is, in mesh coordinates; none: far away, and lengths
    /// across the view are true. What is farther aside than tangent_of_sight is not in the picture.
    std::optional<Eigen::Vector3d> eye = std::nullopt;
};

/// How far to each side a perspective view reaches, for 1 away from the eye: 60 degrees.
constexpr double tangent_of_sight = 1.7320508075688772;

/// A direction of the picture, x right, y up, z to the viewer, in mesh coordinates.
Eigen::Vector3d inMesh(const Eigen::Vector3d& direction, const ViewFrame& frame);

/// "Front" to "Bottom", in the order of Side.
std::array<const char*, 6> sideNames();

/// One of the six sides. A view of a side shows what an observer sees who walks around the object
/// that stands upright; the top view has the object's front at its lower edge, the bottom view at
/// its upper one.
ViewFrame frameOfSide(Side side, UpAxis up);

/// The observer goes from the front by `azimuth` degrees to the right around the object and by
/// `elevation` degrees up, −90 to 90.
/// @throws laplacian_lines::Error(InvalidOption)
ViewFrame frameOfDirection(double azimuth, double elevation, UpAxis up);

/// The front of a vessel as a half section.
ViewFrame frameOfVessel(UpAxis up);

/// Views that a program knows besides.
using NamedViews = std::map<std::string, ViewFrame>;

/// Views from their names, separated by commas or spaces: front, back, left, right, top, bottom,
/// six (all of these), vessel, two numbers, azimuth and elevation, or `others`.
/// @throws laplacian_lines::Error(InvalidOption) with the words that are understood.
std::vector<ViewFrame> parseViews(std::string_view text, UpAxis up, const NamedViews& others = {});

}  // namespace line_drawing
