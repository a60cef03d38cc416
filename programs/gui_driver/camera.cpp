// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera.h"
#include <QApplication>
#include <QClipboard>
#include <QDomDocument>
#include <QtMath>
#include <cmath>
#include "command_table.h"
#include "gui.h"

namespace driver {
namespace {

// MeshLab passes views in and out of a GL view by the clipboard.
QDomDocument viewFromClip() {
    QMetaObject::invokeMethod(requireView(), "copyToClip", Qt::DirectConnection);
    QDomDocument document;
    if (!document.setContent(QApplication::clipboard()->text()) ||
        document.elementsByTagName("VCGCamera").isEmpty())
        throw CommandError("MeshLab's GL view does not tell its camera");
    return document;
}

void viewToClip(const QDomDocument& document) {
    QApplication::clipboard()->setText(document.toString());
    if (!QMetaObject::invokeMethod(requireView(), "pasteFromClip", Qt::DirectConnection))
        throw CommandError("MeshLab's GL view has no slot to take a camera");
    requireView()->update();
}

QString row(const QVector3D& v, int last) {
    return QString("%1 %2 %3 %4 ")
        .arg(v.x(), 0, 'g', 9)
        .arg(v.y(), 0, 'g', 9)
        .arg(v.z(), 0, 'g', 9)
        .arg(last);
}

// MeshLab's camera shows a ball of this radius, in units of the view's scale, around its pivot.
constexpr double ball_radius = 1.75;

double ballDistance(double angle) {
    return ball_radius / std::sin(qDegreesToRadians(angle / 2));
}

}  // namespace

// MeshLab measures depths in the view's scale: it has to grow with the distance, for the same
// clipping as when its own camera zooms.
void placeCamera(const CameraPlace& place) {
    QDomDocument document = viewFromClip();
    QDomElement camera = document.elementsByTagName("VCGCamera").at(0).toElement();
    QDomElement settings = document.elementsByTagName("ViewSettings").at(0).toElement();
    const bool is_orthographic = place.angle <= orthographic_angle;
    const double depth = ballDistance(perspective_angle);
    const double scale = (is_orthographic ? ball_radius : depth) / place.distance;
    const double eye = is_orthographic ? ballDistance(orthographic_angle) / scale : place.distance;
    settings.setAttribute("TrackScale", scale);
    settings.setAttribute("NearPlane", nearest_shown * depth);
    settings.setAttribute("FarPlane", scale * (eye + 1.1 * place.farthest_behind));
    camera.setAttribute("CameraType", is_orthographic ? 1 : 0);
    const double picture_height = camera.attribute("ViewportPx").section(' ', 1, 1).toDouble() *
                                  camera.attribute("PixelSizeMm").section(' ', 1, 1).toDouble();
    camera.setAttribute("FocalMm",
                        picture_height / (2 * std::tan(qDegreesToRadians(place.angle / 2))));
    // rows: the camera's axes; the translation is minus the eye
    const CameraAxes& axes = place.axes;
    camera.setAttribute("RotationMatrix",
                        row(axes.right, 0) + row(axes.up, 0) + row(axes.back, 0) + "0 0 0 1 ");
    camera.setAttribute("TranslationVector",
                        row(-(place.target + float(eye) * axes.back), 1).trimmed());
    viewToClip(document);
}

}  // namespace driver
