// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "laplacian_lines/triangle_mesh.h"

namespace meshlab_host {

/// What to do about a mesh whose drawing is likely to disappoint, in MeshLab's terms: a line of the
/// log for each of laplacian_lines::faults_of().
QStringList meshAdvice(const laplacian_lines::MeshReport& report);

}  // namespace meshlab_host
