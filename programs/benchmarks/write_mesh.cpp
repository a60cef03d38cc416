// SPDX-License-Identifier: GPL-3.0-or-later
// write_mesh stone|vessel|part|FILE [--refine N] FILE.ply: writes as binary PLY a flaked stone of
// 100 mm, a vessel of 200 mm or a machined part of 100 mm with rounded edges as wide as its
// triangles, in metres like scans, or a mesh with its triangles cut in four and rounded, N times.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

#include "flaked_stone.h"
#include "generators.h"
#include "machined_part.h"
#include "mesh_file.h"
#include "midpoint_subdivision.h"
#include "thrown_vessel.h"

namespace {

using laplacian_lines::TriangleMesh;

TriangleMesh make(const std::string& name) {
    if (name == "vessel") return test_meshes::moved(test_meshes::thrown_vessel(), {0, 0, 0}, 1e-3);
    if (name == "part")
        return test_meshes::moved(test_meshes::MachinedPart(0.005).mesh(0.012), {0, 0, 0}, 0.05);
    if (name != "stone") return test_meshes::read_mesh(name);
    test_meshes::StoneShape shape;
    shape.half_axes = {0.6, 1, 0.3};
    return test_meshes::moved(test_meshes::FlakedStone(shape).mesh(8), {0, 0, 0}, 0.05);
}

void write(const TriangleMesh& mesh, const std::string& file) {
    std::ofstream out(file, std::ios::binary);
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.positions.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
        << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Eigen::Vector3d& p : mesh.positions) {
        const Eigen::Vector3f place = p.cast<float>();
        out.write(reinterpret_cast<const char*>(place.data()), 12);
    }
    for (const laplacian_lines::Triangle& t : mesh.triangles) {
        out.put(3);
        out.write(reinterpret_cast<const char*>(t.data()), 12);
    }
    if (!out.flush()) throw std::runtime_error(file + " cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
    const bool refines = argc == 5 && std::string(argv[2]) == "--refine";
    if (argc != 3 && !refines) {
        std::fputs("write_mesh stone|vessel|part|FILE [--refine N] FILE.ply\n", stderr);
        return 2;
    }
    try {
        TriangleMesh mesh = make(argv[1]);
        if (refines) test_meshes::refine(mesh, std::atoi(argv[3]));
        write(mesh, argv[argc - 1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
