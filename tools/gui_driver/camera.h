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

// orbit AZIMUTH ELEVATION: degrees around what the camera turns about, from where MeshLab's
// camera stands at first, which must not have been moved.
void orbit(const Command& command);

// Puts the camera on a circle around what it turns about, as orbit does.
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
