// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QDomDocument>
#include <QVector3D>
#include "command_table.h"

namespace driver {

void loadCamera(
    const QString& file_name);  // XML, as MeshLab's "Save camera settings to file" writes it
void saveCamera(const QString& file_name);

// look EX EY EZ  TX TY TZ  [UX UY UZ]: eye, target, up (default y), scene coordinates. Keeps field
// of view, projection and scale; of an orthographic camera only the direction counts.
void lookFrom(const Command& command);

// In the scene: right, up, and towards the viewer.
struct CameraAxes {
    QVector3D right, up, back;
};

// Degrees to the right around the scene and up, at most 90; 0 0 looks against z with y up. Another
// axis `up` ("x", "z") first turns the scene by the least angle that brings it up: for z, 0 0 looks
// along y.
CameraAxes axesFrom(double azimuth, double elevation, const QString& up);

// The place alone; MeshLab keeps more of a camera.
struct CameraPlace {
    CameraAxes axes;
    QVector3D target;        // any point in the middle of the picture
    double distance;         // of the eye from it; if orthographic, half of the picture's height
    double angle;            // from the bottom of the picture to its top; orthographic_angle
    double farthest_behind;  // how far behind the target there is something to be seen
};
constexpr double perspective_angle = 60, orthographic_angle = 5;  // degrees, as MeshLab has them

void placeCamera(const CameraPlace& place);

// The share of the distance from eye to target that placeCamera clips, and how far before the
// target an orthographic camera clips, in half heights of the picture.
constexpr double nearest_shown = 0.1, orthographic_depth = 4;

// Around the camera's pivot.
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
