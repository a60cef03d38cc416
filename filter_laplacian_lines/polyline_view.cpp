// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyline_view.h"

#include <cmath>

#include "laplacian_lines/error.h"
#include "meshlab_host/camera.h"

using meshlab_host::CurrentView;

namespace {

/// Wider perspective views get a warning.
constexpr double widest_angle = 60;  // degrees

QString inWords(const Eigen::Vector3d& v) {
    return QString("%1 %2 %3").arg(v.x(), 0, 'g', 6).arg(v.y(), 0, 'g', 6).arg(v.z(), 0, 'g', 6);
}

/// y where possible, as in MeshLab's own views.
Eigen::Vector3d upwards(const Eigen::Vector3d& towards_viewer) {
    const double y = towards_viewer.normalized().y();
    const bool is_upright = std::abs(y) < 0.999;
    const Eigen::Vector3d up = is_upright ? Eigen::Vector3d(0, 1, 0) : Eigen::Vector3d(0, 0, -y);
    return (up - up.dot(towards_viewer) * towards_viewer / towards_viewer.squaredNorm())
        .normalized();
}

Eye perspective(const Eigen::Vector3d& viewpoint, const Eigen::Vector3d& towards_viewer,
                const Eigen::Vector3d& up) {
    return {viewpoint.homogeneous(), towards_viewer, up,
            "perspective, from the viewpoint " + inWords(viewpoint)};
}

Eye orthographic(const Eigen::Vector3d& direction, const Eigen::Vector3d& up) {
    Eigen::Vector4d place = Eigen::Vector4d::Zero();
    place.head<3>() = direction;
    return {place, direction.normalized(), up,
            "orthographic, along the view direction " + inWords(direction)};
}

Eye ofWindow(const std::optional<CurrentView>& window) {
    if (!window)
        laplacian_lines::refuse(
            "There is no window with a current view. Set \"View\" to 3 (Front) or another "
            "side, to 1 (Perspective) and give a viewpoint, or to 2 (Orthographic) and "
            "give a view direction.");
    return window->is_orthographic ? orthographic(window->towards_viewer, window->up)
                                   : perspective(window->eye, window->towards_viewer, window->up);
}

/// In world coordinates.
Eigen::Vector3d cameraLight(const Eye& eye, double azimuth) {
    const Eigen::Vector3d in_eye = meshlab_host::towardsLight(azimuth);
    return in_eye.x() * eye.up.cross(eye.towards_viewer) + in_eye.y() * eye.up +
           in_eye.z() * eye.towards_viewer;
}

}  // namespace

Eye eyeOf(const PolylineParameters& chosen, const Eigen::Vector3d& centre,
          const std::optional<CurrentView>& window) {
    switch (chosen.view) {
        case ViewChoice::CurrentView:
            return ofWindow(window);
        case ViewChoice::Perspective: {
            const Eigen::Vector3d back = chosen.viewpoint - centre;
            const Eigen::Vector3d towards_viewer =
                back.isZero(0) ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(back.normalized());
            return perspective(chosen.viewpoint, towards_viewer, upwards(towards_viewer));
        }
        case ViewChoice::Orthographic:
            return orthographic(chosen.view_direction, upwards(chosen.view_direction));
        default:
            break;
    }
    const line_drawing::ViewFrame side = sideView(chosen.view);
    const Eigen::Vector3d towards_viewer = side.towards_viewer + Eigen::Vector3d::Zero();  // no -0
    Eye eye = orthographic(towards_viewer, side.up);
    eye.words += QString(" (%1)").arg(QString::fromStdString(side.name));
    return eye;
}

laplacian_lines::View viewOf(const Eye& eye, const PolylineParameters& chosen,
                             const Eigen::Matrix4d& layer) {
    std::optional<laplacian_lines::View> view = meshlab_host::viewFromWorld(eye.place, layer);
    if (!view)
        laplacian_lines::refuse(
            "The layer's transformation cannot be inverted. Reset it, or freeze it.");
    if (chosen.light_azimuth)
        view->light = meshlab_host::directionInMesh(cameraLight(eye, *chosen.light_azimuth),
                                                    Eigen::Matrix4d::Identity(), layer);
    return *view;
}

QString nearnessWarning(const Eye& eye, const Eigen::AlignedBox3d& box) {
    if (eye.place.w() == 0 || box.isEmpty()) return {};
    const Eigen::Vector3d viewpoint = eye.place.head<3>() / eye.place.w();
    double widest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d ray = box.corner(Eigen::AlignedBox3d::CornerType(corner)) - viewpoint;
        widest = std::max(
            widest, std::atan2(ray.cross(eye.towards_viewer).norm(), -ray.dot(eye.towards_viewer)));
    }
    const bool is_within = box.contains(viewpoint);
    if (!is_within && widest < widest_angle * std::acos(-1.0) / 180) return {};
    return QString(
               "Warning: the viewpoint %1 is %2 of the layer, which reaches from %3 to %4: not "
               "all of it is in sight. Take a viewpoint farther away, or one of the sides as "
               "View, such as Front.")
        .arg(inWords(viewpoint), is_within ? "within the bounding box" : "close to the box",
             inWords(box.min()), inWords(box.max()));
}

void addResults(const Eye& eye, meshlab_host::FilterResults& results) {
    if (eye.place.w() != 0)
        meshlab_host::addResult("viewpoint", eye.place.head<3>() / eye.place.w(), results);
    meshlab_host::addResult("view_direction", eye.towards_viewer, results);
    meshlab_host::addResult("up", eye.up, results);
}
