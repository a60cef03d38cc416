// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyline_view.h"

#include <cmath>

#include "laplacian_lines/error.h"
#include "meshlab_host/camera.h"
#include "window_frame.h"

using line_drawing::ViewFrame;
using meshlab_host::CurrentView;

namespace {

QString numbers_text(const Eigen::Vector3d& v) {
    return QString("%1 %2 %3").arg(v.x(), 0, 'g', 9).arg(v.y(), 0, 'g', 9).arg(v.z(), 0, 'g', 9);
}

/// y where possible, as in MeshLab's own views.
Eigen::Vector3d upwards(const Eigen::Vector3d& towards_viewer) {
    const double y = towards_viewer.normalized().y();
    const bool is_upright = std::abs(y) < 0.999;
    const Eigen::Vector3d up = is_upright ? Eigen::Vector3d(0, 1, 0) : Eigen::Vector3d(0, 0, -y);
    return (up - up.dot(towards_viewer) * towards_viewer / towards_viewer.squaredNorm())
        .normalized();
}

}  // namespace

ViewFrame frame_of(const PolylineParameters& chosen, const Eigen::Vector3d& centre,
                   const std::optional<CurrentView>& window) {
    switch (chosen.view) {
        case ViewChoice::CurrentView:
            if (!window)
                laplacian_lines::refuse(
                    "There is no window with a current view. Set \"View\" to 3 (Front) or another "
                    "side, to 1 (Perspective) and give a viewpoint, or to 2 (Orthographic) and "
                    "give a view direction.");
            return frame_of(*window, "");
        case ViewChoice::Perspective: {
            const Eigen::Vector3d back = chosen.viewpoint - centre;
            const Eigen::Vector3d towards_viewer =
                back.isZero(0) ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(back.normalized());
            return line_drawing::frame_of_axes("", towards_viewer, upwards(towards_viewer),
                                               chosen.viewpoint);
        }
        case ViewChoice::Orthographic:
            return line_drawing::frame_of_axes("", chosen.view_direction.normalized(),
                                               upwards(chosen.view_direction));
        default:
            break;
    }
    const int number = int(chosen.view) - int(ViewChoice::Front);
    ViewFrame side =
        line_drawing::frame_of_side(line_drawing::Side(number), line_drawing::UpAxis::Y);
    side.towards_viewer += Eigen::Vector3d::Zero();  // no -0
    return side;
}

QString view_text(const ViewFrame& frame, const PolylineParameters& chosen) {
    if (frame.eye) return "perspective, from the viewpoint " + numbers_text(*frame.eye);
    const bool is_chosen = chosen.view == ViewChoice::Orthographic;
    const QString words = "orthographic, along the view direction " +
                          numbers_text(is_chosen ? chosen.view_direction : frame.towards_viewer);
    return frame.name.empty() ? words
                              : QString("%1 (%2)").arg(words, QString::fromStdString(frame.name));
}

laplacian_lines::View view_of(const ViewFrame& frame, const PolylineParameters& chosen,
                              const Eigen::Matrix4d& layer) {
    Eigen::Vector4d eye = Eigen::Vector4d::Zero();
    eye.head<3>() = frame.eye.value_or(frame.towards_viewer);
    eye.w() = frame.eye ? 1 : 0;
    laplacian_lines::View view = meshlab_host::view_from(eye, layer);
    if (chosen.light_azimuth)
        view.light = meshlab_host::direction_in_mesh(
            in_mesh(meshlab_host::towards_light(*chosen.light_azimuth), frame),
            Eigen::Matrix4d::Identity(), layer);
    return view;
}

QString nearness_warning(const ViewFrame& frame, const Eigen::AlignedBox3d& box) {
    if (!frame.eye || box.isEmpty()) return {};
    const auto is_in_sight = [&](int corner) {
        const Eigen::Vector3d ray =
            box.corner(Eigen::AlignedBox3d::CornerType(corner)) - *frame.eye;
        return ray.cross(frame.towards_viewer).norm() <
               -line_drawing::kTangentOfHalfView * ray.dot(frame.towards_viewer);
    };
    int corner = 0;
    while (corner < 8 && is_in_sight(corner))
        ++corner;
    const bool is_within = box.contains(*frame.eye);
    if (!is_within && corner == 8) return {};
    return QString(
               "Warning: the viewpoint %1 %2 of the layer, which reaches from %3 to %4. "
               "Take a viewpoint farther away, or one of the sides as "
               "View, such as Front.")
        .arg(numbers_text(*frame.eye),
             is_within ? "is within the bounding box" : "sees only part of the bounding box",
             numbers_text(box.min()), numbers_text(box.max()));
}

void add_results(const ViewFrame& frame, meshlab_host::FilterResults& results) {
    if (frame.eye) meshlab_host::add_result("viewpoint", *frame.eye, results);
    meshlab_host::add_result("view_direction", frame.towards_viewer, results);
    meshlab_host::add_result("up", frame.up, results);
}
