// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera.h"
#include <QApplication>
#include <QClipboard>
#include <QDomDocument>
#include <QFile>
#include <QVector3D>
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

// MeshLab's orthographic camera stands where a perspective one with an angle of 5 degrees would
// show a ball of radius 1.75 (in units of the view's scale), and clips what is nearer than that
// suggests.
double orthographicDistance(const QDomDocument& document) {
    const double scale = document.elementsByTagName("ViewSettings")
                             .at(0)
                             .toElement()
                             .attribute("TrackScale")
                             .toDouble();
    return 1.75 / std::sin(qDegreesToRadians(2.5)) / scale;
}

}  // namespace

void loadCamera(const QString& fileName) {
    QFile file(fileName);
    if (!file.open(QIODevice::ReadOnly))
        throw CommandError(QString("cannot read %1").arg(fileName));
    setCameraText(parseCamera(QString::fromUtf8(file.readAll())).toString());
}

void saveCamera(const QString& fileName) {
    QFile file(fileName);
    const QByteArray text = cameraText().toUtf8();
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        throw CommandError(QString("cannot write %1").arg(fileName));
}

void lookFrom(const Command& command) {
    const QVector3D target = vectorAt(command, 3);
    QVector3D eye = vectorAt(command, 0);
    const QVector3D up = command.words.size() > 6 ? vectorAt(command, 6) : QVector3D(0, 1, 0);
    const QVector3D back = (eye - target).normalized();
    const QVector3D right = QVector3D::crossProduct(up, back).normalized();
    if (right.isNull()) throw CommandError("eye, target and upward direction lie on one line");

    QDomDocument document = parseCamera(cameraText());
    QDomElement camera = document.elementsByTagName("VCGCamera").at(0).toElement();
    if (camera.attribute("CameraType") == "1")
        eye = target + back * float(orthographicDistance(document));
    // rows: the camera's axes; the translation is minus the eye
    camera.setAttribute(
        "RotationMatrix",
        row(right, 0) + row(QVector3D::crossProduct(back, right), 0) + row(back, 0) + "0 0 0 1 ");
    camera.setAttribute("TranslationVector", row(-eye, 1).trimmed());
    // from 2022.02 on, MeshLab keeps the far plane of the text, which was right for the old distance
    document.elementsByTagName("ViewSettings").at(0).toElement().setAttribute("FarPlane", 10000);
    setCameraText(document.toString());
}

}  // namespace driver
