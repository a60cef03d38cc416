// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/mesh_advice.h"

#include "laplacian_lines/mesh_faults.h"

namespace meshlab_host {

using laplacian_lines::MeshFault;
using laplacian_lines::MeshReport;

namespace {

QString percent(double share) {
    return QString::number(100 * share, 'f', 0) + " %";
}

QString advice(MeshFault fault, const MeshReport& report) {
    switch (fault) {
        case MeshFault::Torn:
            return percent(report.border_share) +
                   " of the edges are borders, so there is hardly a surface to draw: run Merge "
                   "Close Vertices.";
        case MeshFault::Disagreeing:
            return percent(report.opposed_share) +
                   " of the edges join triangles that face opposite ways: run Re-Orient All Faces "
                   "Coherently.";
        case MeshFault::InsideOut:
            return "The surface is inside out, so grooves are drawn as ridges: run Invert Faces "
                   "Orientation.";
        case MeshFault::CoarseKernel:
            return "Most of the surface bends within the kernel, so its features are blurred: run "
                   "Compute Laplacian Lines with a smaller Kernel Size.";
    }
    return {};
}

}  // namespace

QStringList meshAdvice(const MeshReport& report) {
    QStringList lines;
    for (const MeshFault fault : laplacian_lines::faults_of(report))
        lines << "Warning: " + advice(fault, report);
    return lines;
}

}  // namespace meshlab_host
