// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QDomDocument>
#include <QVector3D>
#include "command_table.h"

namespace driver {

void loadCamera(
    const QString& file_name);  // XML, as MeshLab's "Save camera settings to file" writes it
void saveCamera(const QString& file_name);

// look EX EY EZ  TX TY TZ  [UX UY UZ]: the eye, a point it looks at, the upward direction (y by
// default), all in the coordinates of the scene. Field of view, projection and scale stay; with an
// orthographic camera only the direction counts.
void lookFrom(const Command& command);

// The camera's axes in the scene: to the right of the picture, up, and to the viewer.
struct CameraAxes {
    QVector3D right, up, back;
};

// Degrees to the right around the scene and up, up to 90 each way; 0 0 looks against the z axis
// with y up. With another axis up ("x", "z"), the scene is first turned by the least angle that
// brings that one up: with z up, 0 0 looks along the y axis.
CameraAxes axesFrom(double azimuth, double elevation, const QString& up);

// Where a camera is, apart from what else MeshLab keeps of it.
struct CameraPlace {
    CameraAxes axes;
    QVector3D target;        // any point in the middle of the picture
    double distance;         // of the eye from it; if orthographic, half of the picture's height
    double angle;            // from the bottom of the picture to its top; orthographic_angle
    double farthest_behind;  // how far behind the target there is something to be seen
};
constexpr double perspective_angle = 60, orthographic_angle = 5;  // degrees, as MeshLab has them

void placeCamera(const CameraPlace& place);

// The share of the distance from eye to target within which placeCamera shows nothing, and how far
// in front of the target an orthographic camera does, in halves of the picture's height.
constexpr double nearest_shown = 0.1, orthographic_depth = 4;

// Puts the camera on a circle around what it turns about.
class Orbit {
public:
    Orbit();                                             // where MeshLab's camera stands at first
    void place(double azimuth, double elevation) const;  // degrees

private:
    QDomDocument document_;
    QVector3D target_;
    float distance_;
};

}  // namespace driver
