// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QVector3D>

namespace driver {

// In the scene: right, up, and towards the viewer.
struct CameraAxes {
    QVector3D right, up, back;
};

// The place alone; MeshLab keeps more of a camera.
struct CameraPlace {
    CameraAxes axes;
    QVector3D target;        // any point in the middle of the picture
    double distance;         // of the eye from it; if orthographic, half of the picture's height
    double angle;            // from the bottom of the picture to its top; orthographic_angle
    double farthest_behind;  // how far behind the target there is something to be seen
};
constexpr double perspective_angle = 60, orthographic_angle = 5;  // degrees, as MeshLab has them

// Without a redraw.
void placeCamera(const CameraPlace& place);

// The share of the distance from eye to target that placeCamera clips, and how far before the
// target an orthographic camera clips, in half heights of the picture.
constexpr double nearest_shown = 0.1, orthographic_depth = 4;

}  // namespace driver
