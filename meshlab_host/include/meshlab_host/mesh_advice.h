// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "laplacian_lines/triangle_mesh.h"

namespace meshlab_host {

/// A line of the log per laplacian_lines::faults_of(), what to do about it in MeshLab's terms.
QStringList meshAdvice(const laplacian_lines::MeshReport& report);

}  // namespace meshlab_host
