// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/mesh_advice.h"

#include "laplacian_lines/mesh_faults.h"

namespace meshlab_host {

QStringList meshAdvice(const laplacian_lines::MeshReport& report) {
    QStringList lines;
    for (const laplacian_lines::MeshFault fault : laplacian_lines::faults_of(report))
        lines << "Warning: " + QString::fromStdString(describe(fault, report));
    return lines;
}

}  // namespace meshlab_host
