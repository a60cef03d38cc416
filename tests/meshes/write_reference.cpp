// SPDX-License-Identifier: GPL-3.0-or-later
// write_reference MESH FOLDER: a mesh of the registry as FOLDER/MESH.ply, and what belongs to each
// of its vertices as FOLDER/MESH.txt, 25 numbers a line: the core's field with the default options
// (n, Δn, diagonal and rest of S as MeshLab's attributes have them, kernel size), then the truth
// (n, Δn, diagonal and rest of S). For tests of programs that are not written in C++.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "laplacian_lines/precompute.h"
#include "registry.h"

namespace {

using laplacian_lines::Field;
using laplacian_lines::TriangleMesh;
using test_meshes::SurfacePoint;
using test_meshes::TestMesh;

std::ofstream open(const std::string& path) {
    std::ofstream file;
    file.exceptions(std::ofstream::failbit | std::ofstream::badbit);
    file.open(path);
    file.precision(std::numeric_limits<float>::max_digits10);  // read back as the same floats
    return file;
}

/// Through text: GCC 12's vectorizer leaves out casts from double to float and back.
double as_read_from_file(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return std::strtof(text, nullptr);
}

TriangleMesh as_read_from_file(TriangleMesh mesh) {
    for (auto& p : mesh.positions)
        for (double& coordinate : p)
            coordinate = as_read_from_file(coordinate);
    return mesh;
}

void write_ply(const TriangleMesh& mesh, const std::string& path) {
    std::ofstream file = open(path);
    file << "ply\nformat ascii 1.0\nelement vertex " << mesh.positions.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
         << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const auto& p : mesh.positions)
        file << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& t : mesh.triangles)
        file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

template <class Vector>
void write_vector(std::ofstream& file, const Vector& v) {
    file << v.x() << ' ' << v.y() << ' ' << v.z() << ' ';
}

void write_field(const TestMesh& mesh, const Field& field, const std::string& path) {
    std::ofstream file = open(path);
    for (std::size_t v = 0; v < mesh.mesh.positions.size(); ++v) {
        const auto& s = field.shape_operators[v];
        write_vector(file, field.normals[v]);
        write_vector(file, field.laplacian_normals[v]);
        file << s.xx << ' ' << s.yy << ' ' << s.zz << ' ' << s.yz << ' ' << s.xz << ' ' << s.xy
             << ' ' << field.kernel_sizes[v] << ' ';
        const SurfacePoint& truth = mesh.truth.at(v);
        const Eigen::Matrix3d& t = truth.shape_operator;
        write_vector(file, truth.normal);
        write_vector(file, truth.laplacian_normal);
        write_vector(file, t.diagonal());
        file << t(1, 2) << ' ' << t(0, 2) << ' ' << t(0, 1) << '\n';
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "write_reference MESH FOLDER\n");
        return 2;
    }
    try {
        const std::string name = argv[1];
        const TestMesh& mesh = test_meshes::mesh_named(name);
        const std::string path = std::string(argv[2]) + "/" + mesh.name;
        const TriangleMesh stored = as_read_from_file(mesh.mesh);
        write_ply(stored, path + ".ply");
        write_field(mesh, laplacian_lines::precompute(stored), path + ".txt");
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "write_reference: %s\n", error.what());
        return 1;
    }
}
