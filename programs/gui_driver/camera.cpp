// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera.h"
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QtMath>
#include <cmath>
#include "gui.h"

namespace driver {
namespace {

// MeshLab passes views in and out of a GL view by the clipboard.
QString cameraText() {
    QMetaObject::invokeMethod(requireView(), "copyToClip", Qt::DirectConnection);
    return QApplication::clipboard()->text();
}

void setCameraText(const QString& text) {
    QApplication::clipboard()->setText(text);
    if (!QMetaObject::invokeMethod(requireView(), "pasteFromClip", Qt::DirectConnection))
        throw CommandError("MeshLab's GL view has no slot to take a camera");
    requireView()->update();
}

QDomDocument parseCamera(const QString& text) {
    QDomDocument document;
    if (!document.setContent(text) || document.elementsByTagName("VCGCamera").isEmpty())
        throw CommandError("this is not a view of MeshLab (XML with a VCGCamera)");
    return document;
}

QDomElement cameraIn(const QDomDocument& document) {
    return document.elementsByTagName("VCGCamera").at(0).toElement();
}

QDomElement settingsIn(const QDomDocument& document) {
    return document.elementsByTagName("ViewSettings").at(0).toElement();
}

QVector3D vectorAt(const Command& command, int first) {
    return QVector3D(float(command.number(first)), float(command.number(first + 1)),
                     float(command.number(first + 2)));
}

QString row(const QVector3D& v, int last) {
    return QString("%1 %2 %3 %4 ")
        .arg(v.x(), 0, 'g', 9)
        .arg(v.y(), 0, 'g', 9)
        .arg(v.z(), 0, 'g', 9)
        .arg(last);
}

// MeshLab's camera, at this angle, shows a ball of radius 1.75, in units of the view's scale,
// around its pivot.
constexpr double ball_radius = 1.75;

double viewingDistance(const QDomDocument& document, double angle) {
    const double scale = settingsIn(document).attribute("TrackScale").toDouble();
    return ball_radius / std::sin(qDegreesToRadians(angle / 2)) / scale;
}

QVector3D translation(const QDomElement& camera) {
    const QStringList numbers = camera.attribute("TranslationVector").split(' ');
    if (numbers.size() < 3) throw CommandError("MeshLab's view has no translation");
    return QVector3D(numbers[0].toFloat(), numbers[1].toFloat(), numbers[2].toFloat());
}

// rows: the camera's axes; the translation is minus the eye
void setPlace(QDomElement camera, const QVector3D& eye, const CameraAxes& axes) {
    camera.setAttribute("RotationMatrix",
                        row(axes.right, 0) + row(axes.up, 0) + row(axes.back, 0) + "0 0 0 1 ");
    camera.setAttribute("TranslationVector", row(-eye, 1).trimmed());
}

// orthographic cameras clip what is nearer than their own distance
void look(QDomDocument& document, QVector3D eye, const QVector3D& target, const QVector3D& up) {
    const QVector3D back = (eye - target).normalized();
    const QVector3D right = QVector3D::crossProduct(up, back).normalized();
    if (right.isNull()) throw CommandError("eye, target and upward direction lie on one line");
    if (cameraIn(document).attribute("CameraType") == "1")
        eye = target + back * float(viewingDistance(document, orthographic_angle));
    setPlace(cameraIn(document), eye, {right, QVector3D::crossProduct(back, right), back});
    // From 2022.02 on, MeshLab keeps the text's far plane, which suits the old distance.
    settingsIn(document).setAttribute("FarPlane", 10000);
    setCameraText(document.toString());
}

}  // namespace

void loadCamera(const QString& file_name) {
    QFile file(file_name);
    if (!file.open(QIODevice::ReadOnly))
        throw CommandError(QString("cannot read %1").arg(file_name));
    setCameraText(parseCamera(QString::fromUtf8(file.readAll())).toString());
}

void saveCamera(const QString& file_name) {
    writeFile(file_name, cameraText().toUtf8());
}

void lookFrom(const Command& command) {
    QDomDocument document = parseCamera(cameraText());
    look(document, vectorAt(command, 0), vectorAt(command, 3),
         command.words.size() > 6 ? vectorAt(command, 6) : QVector3D(0, 1, 0));
}

CameraAxes axesFrom(double azimuth, double elevation, const QString& up) {
    const double a = qDegreesToRadians(azimuth), e = qDegreesToRadians(elevation);
    const auto turned = [&](double x, double y, double z) {
        if (up == "x") return QVector3D(float(y), float(-x), float(z));
        if (up == "y") return QVector3D(float(x), float(y), float(z));
        if (up == "z") return QVector3D(float(x), float(-z), float(y));
        throw CommandError("the axis that is up is x, y or z, not " + up);
    };
    return {turned(std::cos(a), 0, -std::sin(a)),
            turned(-std::sin(a) * std::sin(e), std::cos(e), -std::cos(a) * std::sin(e)),
            turned(std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e))};
}

// MeshLab measures depths in the view's scale: it has to grow with the distance, for the same
// clipping as when its own camera zooms.
void placeCamera(const CameraPlace& place) {
    QDomDocument document = parseCamera(cameraText());
    QDomElement camera = cameraIn(document), settings = settingsIn(document);
    const bool is_orthographic = place.angle <= orthographic_angle;
    const double depth = ball_radius / std::sin(qDegreesToRadians(perspective_angle / 2));
    const double scale = (is_orthographic ? ball_radius : depth) / place.distance;
    settings.setAttribute("TrackScale", scale);
    settings.setAttribute("NearPlane", nearest_shown * depth);
    const double eye =
        is_orthographic ? viewingDistance(document, orthographic_angle) : place.distance;
    settings.setAttribute("FarPlane", scale * (eye + 1.1 * place.farthest_behind));
    camera.setAttribute("CameraType", is_orthographic ? 1 : 0);
    const double picture_height = camera.attribute("ViewportPx").section(' ', 1, 1).toDouble() *
                                  camera.attribute("PixelSizeMm").section(' ', 1, 1).toDouble();
    camera.setAttribute("FocalMm",
                        picture_height / (2 * std::tan(qDegreesToRadians(place.angle / 2))));
    setPlace(camera, place.target + float(eye) * place.axes.back, place.axes);
    setCameraText(document.toString());
}

Orbit::Orbit() : document_(parseCamera(cameraText())) {
    distance_ = float(viewingDistance(document_, perspective_angle));
    target_ = -translation(cameraIn(document_)) - QVector3D(0, 0, distance_);
}

void Orbit::place(double azimuth, double elevation) const {
    const CameraAxes axes = axesFrom(azimuth, elevation, "y");
    QDomDocument document = document_;
    look(document, target_ + distance_ * axes.back, target_, axes.up);
}

}  // namespace driver
