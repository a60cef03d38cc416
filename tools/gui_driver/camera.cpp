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

// MeshLab's way to hand views in and out of a GL view is the clipboard.
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

// MeshLab's camera stands where one with this angle shows a ball of radius 1.75, in units of the
// view's scale, around what it turns about.
double viewingDistance(const QDomDocument& document, double angle) {
    const double scale = document.elementsByTagName("ViewSettings")
                             .at(0)
                             .toElement()
                             .attribute("TrackScale")
                             .toDouble();
    return 1.75 / std::sin(qDegreesToRadians(angle / 2)) / scale;
}

constexpr double perspective_angle = 60, orthographic_angle = 5;

QVector3D translation(const QDomElement& camera) {
    const QStringList numbers = camera.attribute("TranslationVector").split(' ');
    if (numbers.size() < 3) throw CommandError("MeshLab's view has no translation");
    return QVector3D(numbers[0].toFloat(), numbers[1].toFloat(), numbers[2].toFloat());
}

// orthographic cameras clip what is nearer than their own distance
void look(QDomDocument& document, QVector3D eye, const QVector3D& target, const QVector3D& up) {
    const QVector3D back = (eye - target).normalized();
    const QVector3D right = QVector3D::crossProduct(up, back).normalized();
    if (right.isNull()) throw CommandError("eye, target and upward direction lie on one line");
    QDomElement camera = document.elementsByTagName("VCGCamera").at(0).toElement();
    if (camera.attribute("CameraType") == "1")
        eye = target + back * float(viewingDistance(document, orthographic_angle));
    // rows: the camera's axes; the translation is minus the eye
    camera.setAttribute(
        "RotationMatrix",
        row(right, 0) + row(QVector3D::crossProduct(back, right), 0) + row(back, 0) + "0 0 0 1 ");
    camera.setAttribute("TranslationVector", row(-eye, 1).trimmed());
    // from 2022.02 on, MeshLab keeps the far plane of the text, which was right for the old
    // distance
    document.elementsByTagName("ViewSettings").at(0).toElement().setAttribute("FarPlane", 10000);
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
    QFile file(file_name);
    const QByteArray text = cameraText().toUtf8();
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        throw CommandError(QString("cannot write %1").arg(file_name));
}

void lookFrom(const Command& command) {
    QDomDocument document = parseCamera(cameraText());
    look(document, vectorAt(command, 0), vectorAt(command, 3),
         command.words.size() > 6 ? vectorAt(command, 6) : QVector3D(0, 1, 0));
}

Orbit::Orbit() : document_(parseCamera(cameraText())) {
    distance_ = float(viewingDistance(document_, perspective_angle));
    const QDomElement camera = document_.elementsByTagName("VCGCamera").at(0).toElement();
    target_ = -translation(camera) - QVector3D(0, 0, distance_);
}

void Orbit::place(double azimuth, double elevation) const {
    azimuth = qDegreesToRadians(azimuth);
    elevation = qDegreesToRadians(elevation);
    const QVector3D towards(float(std::sin(azimuth) * std::cos(elevation)),
                            float(std::sin(elevation)),
                            float(std::cos(azimuth) * std::cos(elevation)));
    QDomDocument document = document_;
    look(document, target_ + distance_ * towards, target_, QVector3D(0, 1, 0));
}

void orbit(const Command& command) {
    Orbit().place(command.number(0), command.number(1));
}

}  // namespace driver
