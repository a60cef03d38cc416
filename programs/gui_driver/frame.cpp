// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include <QtMath>
#include <algorithm>
#include <cmath>

#include "camera.h"
#include "command_table.h"
#include "core_lines.h"
#include "framing.h"
#include "gui.h"
#include "laplacian_lines/precompute.h"
#include "meshlab_host/camera.h"
#include "situation.h"

namespace driver {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double margin = 0.05;        // of the shorter side
constexpr double line_pixels = 2;      // an outline lies half outside the form
constexpr std::size_t few_points = 8;  // each of which may be at a side
constexpr double least_share = 1e-4;   // of the box of all, of what is in its middle

/// Corners of a layer's faces, in the scene.
void appendCorners(const CMeshO& mesh, Points& points) {
    std::vector<bool> is_corner(mesh.vert.size());
    for (const CFaceO& face : mesh.face)
        for (int i = 0; i < 3 && !face.IsD(); ++i)
            is_corner[vcg::tri::Index(mesh, face.cV(i))] = true;
    const Eigen::Affine3d to_scene(meshlab_host::layerTransform(mesh));
    for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
        if (!is_corner[i]) continue;
        const auto& p = mesh.vert[i].cP();
        const Eigen::Vector3d point = to_scene * Eigen::Vector3d(p[0], p[1], p[2]);
        if (point.allFinite()) points.push_back(point);
    }
}

Points allCorners() {
    Points points;
    for (const MeshModel* layer : presentSituation().layers)
        appendCorners(layer->cm, points);
    return points;
}

Eigen::AlignedBox3d boxOf(const Points& points) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : points)
        box.extend(p);
    return box;
}

/// Of the points' box, without a hundredth of them on each side.
double diagonalOfMost(const Points& points) {
    const std::size_t aside = points.size() / 100 + 1;
    if (points.size() < few_points) return boxOf(points).diagonal().norm();
    Eigen::Vector3d sizes;
    std::vector<double> coordinates(points.size());
    for (int k = 0; k < 3; ++k) {
        std::transform(points.begin(), points.end(), coordinates.begin(),
                       [&](const Eigen::Vector3d& p) { return p[k]; });
        const auto low = coordinates.begin() + std::ptrdiff_t(aside),
                   high = coordinates.end() - 1 - std::ptrdiff_t(aside);
        std::nth_element(coordinates.begin(), low, coordinates.end());
        std::nth_element(std::next(low), high, coordinates.end());  // leaves *low in its place
        sizes[k] = *high - *low;
    }
    return sizes.norm();
}

/// Into the camera's axes around `origin`.
void turn(Points& points, const Eigen::Vector3d& origin, const CameraAxes& axes) {
    Eigen::Matrix3d rotation;
    rotation << axes.right.x(), axes.right.y(), axes.right.z(),  //
        axes.up.x(), axes.up.y(), axes.up.z(),                   //
        axes.back.x(), axes.back.y(), axes.back.z();
    for (Eigen::Vector3d& p : points)
        p = rotation * (p - origin);
}

/// The part to fill of a picture of height 2.
Window windowWithinMargin(const QSize& view) {
    const double width = view.width(), height = view.height();
    const double border = margin * std::min(width, height) + line_pixels;
    return {(width - 2 * border) / height, (height - 2 * border) / height};
}

/// The next distance that the mouse wheel reaches from MeshLab's first camera, in quarter notches.
double wheelDistance(double least, double diagonal) {
    const double first = diagonal * 1.75 / 3 / std::tan(qDegreesToRadians(perspective_angle / 2));
    const double step = std::pow(1.2, 0.25);
    return first * std::pow(step, std::ceil(std::log(least / first) / std::log(step)));
}

/// The target, in the points' coordinates, is the box's centre moved across the picture.
CameraPlace perspectivePlace(const Points& points, Window window, double zoom, double diagonal) {
    const double tangent = std::tan(qDegreesToRadians(perspective_angle / 2));
    window.half_width *= tangent;
    window.half_height *= tangent;
    const double least = leastDistance(points, window, nearest_shown);
    const Eigen::Vector3d eye = centredEye(points, wheelDistance(least, diagonal));
    CameraPlace place;
    place.target = QVector3D(float(eye.x()), float(eye.y()), 0);
    place.distance = eye.z();
    place.angle = 2 * qRadiansToDegrees(std::atan(tangent / zoom));
    return place;
}

CameraPlace orthographicPlace(const Points& points, const Window& window, double zoom,
                              double nearest_to_eye) {
    const ParallelFrame frame = parallelFrame(points, window);
    CameraPlace place;
    place.target = QVector3D(float(frame.middle.x()), float(frame.middle.y()), 0);
    place.distance = std::max(frame.scale / zoom, nearest_to_eye / orthographic_depth);
    place.angle = orthographic_angle;
    return place;
}

double noted_pixels_to_unit = 0;

/// At the camera's target.
double pixelsToUnit(const CameraPlace& place, bool is_orthographic, int height) {
    const double tangent = is_orthographic ? 1 : std::tan(qDegreesToRadians(place.angle / 2));
    return height / (2 * place.distance * tangent);
}

double zoomIn(const Command& command) {
    const double zoom = command.words.size() > 3 ? command.number(3) : 1;
    if (!(zoom > 0)) throw CommandError("the zoom has to be positive");
    return zoom;
}

// AZIMUTH ELEVATION [UP [ZOOM [orthographic]]]: fits the surfaces of all layers into the view up to
// a margin. Computed from the vertices: the view need not be drawn.
void frame(const Command& command) {
    const CameraAxes axes = axesFrom(command.number(0), command.number(1), command.wordOr(2, "y"));
    const bool is_orthographic = command.wordOr(4, "") == "orthographic";
    Points points = allCorners();
    Eigen::AlignedBox3d box = boxOf(points);
    if (box.isEmpty() || box.sizes().isZero(0))
        throw CommandError("there is no surface to look at");
    if (diagonalOfMost(points) < least_share * box.diagonal().norm())
        throw CommandError(
            "a few vertices lie so far off that nothing could be seen of the rest; delete them");
    const Eigen::Vector3d centre = box.center();
    const double diagonal = box.diagonal().norm();
    turn(points, centre, axes);
    box = boxOf(points);
    const Window window = windowWithinMargin(requireView()->size());
    const double zoom = zoomIn(command);
    CameraPlace place = is_orthographic ? orthographicPlace(points, window, zoom, box.max().z())
                                        : perspectivePlace(points, window, zoom, diagonal);
    place.axes = axes;
    place.farthest_behind = -box.min().z();
    noted_pixels_to_unit = pixelsToUnit(place, is_orthographic, requireView()->height());
    const QVector3D shift = place.target;
    place.target = QVector3D(float(centre.x()), float(centre.y()), float(centre.z())) +
                   shift.x() * axes.right + shift.y() * axes.up;
    placeCamera(place);
}

// FILE: the current layer's default kernel size in the decoration, pixels of the last frame.
void writeKernel(const Command& command) {
    const MeshModel* mesh = presentSituation().current;
    if (!mesh || noted_pixels_to_unit == 0) throw CommandError("nothing has been framed");
    const double kernel = laplacian_lines::measure_scale(liveTriangles(mesh->cm)).kernel_size;
    writeFile(command.rest, QByteArray::number(kernel * noted_pixels_to_unit) + '\n');
}

}  // namespace

void addFrameCommands(CommandTable& table) {
    table.addSimple("frame", frame);
    table.addSimple("write-kernel", writeKernel);
}

}  // namespace driver
