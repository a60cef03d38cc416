// SPDX-License-Identifier: GPL-3.0-or-later
// The command that fits the surfaces of all layers into the view: where the camera has to be, and
// how MeshLab takes it there.
#include <GL/glew.h>  // before any other GL header

#include <Eigen/Geometry>
#include <QApplication>
#include <QClipboard>
#include <QDomDocument>
#include <QtMath>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "command_table.h"
#include "gui.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/documents.h"

namespace driver {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kMargin = 0.05;       // of the shorter side
constexpr double kLinePixels = 2;      // an outline lies half outside the form
constexpr std::size_t kFewPoints = 8;  // of fewer, each may be at a side of the box
constexpr double kLeastShare = 1e-4;   // of the diagonal of all points, for that of most

/// The position and direction of MeshLab's camera; axes and target are floats, as there.
struct CameraPlace {
    Eigen::Matrix3f axes;    // in the scene: rows right, up, and towards the viewer
    Eigen::Vector3f target;  // any point in the middle of the picture
    double distance;         // of the eye from it; if orthographic, half of the picture's height
    double angle;  // degrees from the picture's bottom to its top; orthographic up to 5, as there
    double farthest_behind = 0;  // depth of the scene behind the target
};
constexpr double kPerspectiveAngle = 60, kOrthographicAngle = 5;  // degrees, as MeshLab has them

// MeshLab's pictures have this half height at the target, in units of the view's scale.
constexpr double kHalfHeight = 1.75;

// The share of the distance from eye to target that is clipped, and how far before the target an
// orthographic camera shows, in half heights: its eye stands 8 units before it.
constexpr double kNearestShown = 0.1, kOrthographicDepth = 4;

/// Corners of a layer's faces, in the scene.
void append_corners(const CMeshO& mesh, Points& points) {
    std::vector<bool> is_corner(mesh.vert.size());
    for (const CFaceO& face : mesh.face)
        for (int i = 0; i < 3 && !face.IsD(); ++i)
            is_corner[vcg::tri::Index(mesh, face.cV(i))] = true;
    const Eigen::Affine3d to_scene(meshlab_host::layer_transform(mesh));
    for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
        if (!is_corner[i]) continue;
        const auto& p = mesh.vert[i].cP();
        const Eigen::Vector3d point = to_scene * Eigen::Vector3d(p[0], p[1], p[2]);
        if (point.allFinite()) points.push_back(point);
    }
}

Eigen::AlignedBox3d box_of(const Points& points) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : points)
        box.extend(p);
    return box;
}

/// Diagonal of the points' bounding box, without a hundredth of them, and one, on each side; of all
/// if they are few.
double diagonal_of_most(const Points& points) {
    if (points.size() < kFewPoints) return box_of(points).diagonal().norm();
    const std::size_t aside = points.size() / 100 + 1;
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

Points all_corners() {
    Points points;
    if (const MeshDocument* document = shown_document())
        for (const MeshModel* layer : meshlab_host::layers_of(*document))
            append_corners(layer->cm, points);
    const Eigen::AlignedBox3d box = box_of(points);
    if (box.isEmpty() || box.sizes().isZero(0))
        throw CommandError("there is no surface to look at");
    if (diagonal_of_most(points) < kLeastShare * box.diagonal().norm())
        throw CommandError(
            "a few vertices lie so far off that nothing could be seen of the rest; delete them");
    return points;
}

/// Degrees to the right around the scene and up, at most 90; 0 0 looks against z with y up. Another
/// axis `up` first turns the scene by the least angle that brings it up: for z, 0 0 looks along y.
Eigen::Matrix3f axes_from(double azimuth, double elevation, const QString& up) {
    const double a = qDegreesToRadians(azimuth), e = qDegreesToRadians(elevation);
    Eigen::Matrix3d axes, turned;
    axes << std::cos(a), 0, -std::sin(a),  //
        -std::sin(a) * std::sin(e), std::cos(e), -std::cos(a) * std::sin(e),
        std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e);
    if (up == "x")
        turned << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    else if (up == "y")
        turned.setIdentity();
    else if (up == "z")
        turned << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    else
        throw CommandError("the axis that is up is x, y or z, not " + up);
    return (axes * turned).cast<float>();
}

/// Half of the part to fill of a picture of height 2.
Eigen::Vector2d window_within_margin(const QSize& view) {
    const double border = kMargin * std::min(view.width(), view.height()) + kLinePixels;
    return Eigen::Vector2d(view.width() - 2 * border, view.height() - 2 * border) / view.height();
}

/// How far from the origin an eye has to be to show all points within the window along an axis of
/// the picture: p is if |p[axis] - eye[axis]| <= half_size (eye.z - p.z). `half_size` is that of
/// the window, at a distance of 1.
double least_distance(const Points& points, int axis, double half_size) {
    double left = -std::numeric_limits<double>::infinity(), right = left;
    for (const Eigen::Vector3d& p : points) {
        right = std::max(right, p[axis] + half_size * p.z());
        left = std::max(left, -p[axis] + half_size * p.z());
    }
    return (left + right) / (2 * half_size);
}

/// Where the eye sees the outermost points on both sides at the same angle. Which these are changes
/// as the eye moves, since near ones shift faster: iterate until they stay.
double middle_seen_from(double distance, const Points& points, int axis) {
    constexpr int most_rounds = 20;
    double eye = 0;
    for (int round = 0; round < most_rounds; ++round) {
        const auto [left, right] = std::minmax_element(
            points.begin(), points.end(), [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
                return (p[axis] - eye) / (distance - p.z()) < (q[axis] - eye) / (distance - q.z());
            });
        const double l = 1 / (distance - left->z()), r = 1 / (distance - right->z());
        const double next = ((*left)[axis] * l + (*right)[axis] * r) / (l + r);
        if (next == eye) break;
        eye = next;
    }
    return eye;
}

/// The next distance by quarter notches of the wheel from MeshLab's first, 3 units to a diagonal.
double wheel_distance(double least, double diagonal) {
    const double first =
        diagonal * kHalfHeight / 3 / std::tan(qDegreesToRadians(kPerspectiveAngle / 2));
    const double step = std::pow(1.2, 0.25);
    return first * std::pow(step, std::ceil(std::log(least / first) / std::log(step)));
}

/// The target, in the points' coordinates, is the origin moved across the picture.
CameraPlace perspective_place(const Points& points, const Eigen::Vector2d& window, double zoom,
                              double diagonal) {
    const double tangent = std::tan(qDegreesToRadians(kPerspectiveAngle / 2));
    double least = 0;
    for (int axis = 0; axis < 2; ++axis)
        least = std::max(least, least_distance(points, axis, tangent * window[axis]));
    for (const Eigen::Vector3d& p : points)
        least = std::max(least, p.z() / (1 - kNearestShown));
    CameraPlace place;
    place.distance = wheel_distance(least, diagonal);
    place.target << float(middle_seen_from(place.distance, points, 0)),
        float(middle_seen_from(place.distance, points, 1)), 0;
    place.angle = 2 * qRadiansToDegrees(std::atan(tangent / zoom));
    if (place.angle <= kOrthographicAngle)
        throw CommandError("MeshLab has no such zoom in perspective");
    return place;
}

CameraPlace orthographic_place(const Eigen::AlignedBox3d& box, const Eigen::Vector2d& window,
                               double zoom) {
    const Eigen::Vector3d middle = box.center(), sizes = box.sizes() / 2;
    CameraPlace place;
    place.target << float(middle.x()), float(middle.y()), 0;
    place.distance = std::max(sizes.x() / window.x(), sizes.y() / window.y()) / zoom;
    place.distance = std::max(place.distance, box.max().z() / kOrthographicDepth);
    place.angle = kOrthographicAngle;
    return place;
}

/// MeshLab passes views in and out of a GL view by the clipboard.
QDomDocument view_from_clip() {
    QMetaObject::invokeMethod(require_view(), "copyToClip", Qt::DirectConnection);
    QDomDocument document;
    if (!document.setContent(QApplication::clipboard()->text()) ||
        document.elementsByTagName("VCGCamera").isEmpty())
        throw CommandError("MeshLab's GL view does not tell its camera");
    return document;
}

void view_to_clip(const QDomDocument& document) {
    QApplication::clipboard()->setText(document.toString());
    if (!QMetaObject::invokeMethod(require_view(), "pasteFromClip", Qt::DirectConnection))
        throw CommandError("MeshLab's GL view has no slot to take a camera");
    require_view()->update();
}

QString row(const Eigen::Vector3f& v, int last) {
    return QString("%1 %2 %3 %4 ")
        .arg(v.x(), 0, 'g', 9)
        .arg(v.y(), 0, 'g', 9)
        .arg(v.z(), 0, 'g', 9)
        .arg(last);
}

/// Units of the view's scale: from there a ball with the radius kHalfHeight just fits into the
/// view.
double ball_distance(double angle) {
    return kHalfHeight / std::sin(qDegreesToRadians(angle / 2));
}

// MeshLab clips at depths in the view's scale, which is therefore inverse to the distance, as when
// its own camera zooms.
void place_camera(const CameraPlace& place) {
    QDomDocument document = view_from_clip();
    QDomElement camera = document.elementsByTagName("VCGCamera").at(0).toElement();
    QDomElement settings = document.elementsByTagName("ViewSettings").at(0).toElement();
    const bool is_orthographic = place.angle <= kOrthographicAngle;
    const double depth = ball_distance(kPerspectiveAngle);
    const double scale = (is_orthographic ? kHalfHeight : depth) / place.distance;
    const double eye = is_orthographic ? ball_distance(kOrthographicAngle) / scale : place.distance;
    settings.setAttribute("TrackScale", scale);
    settings.setAttribute("NearPlane", kNearestShown * depth);
    settings.setAttribute("FarPlane", scale * (eye + 1.1 * place.farthest_behind));
    camera.setAttribute("CameraType", is_orthographic ? 1 : 0);
    const double picture_height = camera.attribute("ViewportPx").section(' ', 1, 1).toDouble() *
                                  camera.attribute("PixelSizeMm").section(' ', 1, 1).toDouble();
    camera.setAttribute("FocalMm",
                        picture_height / (2 * std::tan(qDegreesToRadians(place.angle / 2))));
    const auto axis = [&](int i) { return row(place.axes.row(i), 0); };
    camera.setAttribute("RotationMatrix", axis(0) + axis(1) + axis(2) + "0 0 0 1 ");
    const Eigen::Vector3f eye_place = place.target + float(eye) * place.axes.row(2).transpose();
    camera.setAttribute("TranslationVector", row(-eye_place, 1).trimmed());
    view_to_clip(document);
}

// AZIMUTH ELEVATION [UP [ZOOM [orthographic]]], computed from the vertices: the view need not be
// drawn.
void frame(const Command& command) {
    const Eigen::Matrix3f axes =
        axes_from(command.number(0), command.number(1), command.words.value(2, "y"));
    const double zoom = command.words.size() > 3 ? command.number(3) : 1;
    if (!(zoom > 0)) throw CommandError("the zoom has to be positive");
    Points points = all_corners();
    const Eigen::AlignedBox3d in_scene = box_of(points);
    const Eigen::Vector3d centre = in_scene.center();
    for (Eigen::Vector3d& p : points)
        p = axes.cast<double>() * (p - centre);
    const Eigen::AlignedBox3d box = box_of(points);
    const Eigen::Vector2d window = window_within_margin(require_view()->size());
    CameraPlace place = command.words.value(4) == "orthographic"
                            ? orthographic_place(box, window, zoom)
                            : perspective_place(points, window, zoom, in_scene.diagonal().norm());
    place.axes = axes;
    place.farthest_behind = -box.min().z();
    const Eigen::Vector3f shift = place.target;
    place.target = centre.cast<float>() + shift.x() * axes.row(0).transpose() +
                   shift.y() * axes.row(1).transpose();
    place_camera(place);
}

// [UP]: without one z if the surfaces are clearly higher along it than wide, as many scans of
// figures are. MeshLab's first view has the front already if y is up.
void frame_upright(const Command& command) {
    constexpr double least_height = 1.3;  // in the larger of the other sizes
    Eigen::Vector3d sizes;
    try {
        sizes = box_of(all_corners()).sizes();
    } catch (const CommandError&) {
        return;  // there is nothing to look at
    }
    const bool is_high = sizes.z() > least_height * std::max(sizes.x(), sizes.y());
    const QString up = command.words.value(0, is_high ? "z" : "y");
    if (up != "y") frame(parse_line("frame 0 0 " + up));
}

}  // namespace

void add_frame_commands(CommandTable& table) {
    table["frame"] = {frame};
    table["frame-upright"] = {frame_upright};
}

}  // namespace driver
