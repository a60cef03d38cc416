// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include "noisy_mesh.h"

#include <QFile>
#include <QTextStream>

#include "command_table.h"
#include "core_lines.h"
#include "mesh_noise.h"
#include "situation.h"

namespace driver {
namespace {

using laplacian_lines::TriangleMesh;

void writePly(const TriangleMesh& mesh, const QString& name) {
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly)) throw CommandError("cannot write " + name);
    QTextStream text(&file);
    text.setRealNumberPrecision(9);
    text << "ply\nformat ascii 1.0\nelement vertex " << mesh.positions.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
         << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Eigen::Vector3d& p : mesh.positions)
        text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& triangle : mesh.triangles)
        text << "3 " << triangle[0] << ' ' << triangle[1] << ' ' << triangle[2] << '\n';
}

}  // namespace

void writeNoisy(const Command& command) {
    const MeshModel* layer = presentSituation().current;
    if (!layer) throw CommandError("there is no layer");
    writePly(mesh_noise::with_noise(liveTriangles(layer->cm), command.number(0),
                                    unsigned(command.number(1))),
             command.word(2));
}

}  // namespace driver
