// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include "noisy_mesh.h"

#include <QFile>
#include <QTextStream>
#include <cmath>
#include <random>

#include "command_table.h"
#include "core_lines.h"
#include "laplacian_lines/precompute.h"
#include "situation.h"

namespace driver {
namespace {

using laplacian_lines::TriangleMesh;

/// From -1 to 1, of the generator's own numbers: std's distributions differ between libraries.
double signedUnit(std::mt19937& random) {
    return 2 * (double(random()) / 4294967295.0) - 1;
}

/// All are as likely: points of the cube that are not inside the ball are drawn anew.
Eigen::Vector3d randomDirection(std::mt19937& random) {
    while (true) {
        const double x = signedUnit(random), y = signedUnit(random), z = signedUnit(random);
        const Eigen::Vector3d p(x, y, z);
        if (p.norm() <= 1 && p.norm() > 0.01) return p.normalized();
    }
}

void addNoise(double share, unsigned seed, TriangleMesh& mesh) {
    const double length = share * laplacian_lines::measure_scale(mesh).mean_edge;
    std::mt19937 random(seed);
    for (Eigen::Vector3d& p : mesh.positions)
        p += length * randomDirection(random);
}

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
    TriangleMesh mesh = liveTriangles(layer->cm);
    addNoise(command.number(0), unsigned(command.number(1)), mesh);
    writePly(mesh, command.word(2));
}

}  // namespace driver
