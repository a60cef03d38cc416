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

/// Which mesh axis points up. The front view looks along +y if that is z, else along −z.
enum class UpAxis { X, Y, Z };

/// Which side a view shows; Other: any direction.
enum class Side { Front, Back, Left, Right, Top, Bottom, Other };

/// The axes of a picture in mesh coordinates: orthonormal, right × up = towards_viewer.
struct ViewFrame {
    Side side = Side::Front;
    std::string name;  ///< for people, "Front" or "View 30°, 15°"
    Eigen::Vector3d right, up, towards_viewer;
    /// Of a vessel: the section and the inside behind it on the left of the axis, the outside on
    /// the right.
    bool is_half_section = false;
    /// The eye of a perspective view, mesh coordinates; none: orthographic.
    std::optional<Eigen::Vector3d> eye = std::nullopt;
};

/// Of 60 degrees: perspective views are clipped so far off their axis.
constexpr double kTangentOfHalfView = 1.7320508075688772;

/// From any direction; unit vectors.
ViewFrame frame_of_axes(const std::string& name, const Eigen::Vector3d& towards_viewer,
                        const Eigen::Vector3d& up,
                        const std::optional<Eigen::Vector3d>& eye = std::nullopt);

/// From picture coordinates, x right, y up, z to the viewer, to mesh coordinates.
Eigen::Vector3d in_mesh(const Eigen::Vector3d& direction, const ViewFrame& frame);

/// In the order of Side.
inline constexpr std::array<const char*, 6> kSideNames = {"Front", "Back", "Left",
                                                          "Right", "Top",  "Bottom"};

/// As when walking around the upright object; the object's front is at the lower edge of the top
/// view and at the upper edge of the bottom view.
ViewFrame frame_of_side(Side side, UpAxis up);

/// The front view turned by `azimuth` degrees to the right around the object and `elevation`
/// degrees up, −90 to 90. @throws laplacian_lines::Error(InvalidOption)
ViewFrame frame_of_direction(double azimuth, double elevation, UpAxis up);

/// A plane across an axis of the mesh.
struct Section {
    int axis = 0;        ///< 0 to 2: x, y, z
    double share = 0.5;  ///< position in the bounding box, 0 to 1
};

/// From names such as "y=0.5", separated by commas or spaces.
/// @throws laplacian_lines::Error(InvalidOption)
std::vector<Section> parse_sections(std::string_view text);

/// "A", "B", ..., "Z", "AA", ...
std::string letter_of(std::size_t number);

/// Looks along the section's axis: from above, from the front or from the left.
ViewFrame frame_of_section(const Section& section, UpAxis up);

/// For any view: "toward", the direction to the viewer, that of the picture's upper edge and, in
/// perspective, "from" and the eye, all in mesh coordinates.
std::string frame_text(const ViewFrame& frame);

/// A program's own views.
using NamedViews = std::map<std::string, ViewFrame>;

/// From names separated by commas or spaces: front, back, left, right, top, bottom, six (all of
/// these), vessel, azimuth and elevation, frame_text(), or names in `others`.
/// @throws laplacian_lines::Error(InvalidOption) that says what is understood
std::vector<ViewFrame> parse_views(std::string_view text, UpAxis up, const NamedViews& others = {});

}  // namespace line_drawing
