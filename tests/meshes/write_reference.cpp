// SPDX-License-Identifier: GPL-3.0-or-later
// write_reference MESH FOLDER: a mesh of the registry that has a truth, as FOLDER/MESH.ply and, in
// FOLDER/MESH.txt, a line per vertex: the core's field with the default options, as in MeshLab's
// attributes, then the truth (n, Δn, diagonal and rest of S). The first line has the layout, #
// NAME:NUMBERS..., with "true_" before names of the truth. For tests in other languages.
#include <cstdio>
#include <fstream>
#include <limits>

#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/precompute.h"
#include "registry.h"

namespace {

using laplacian_lines::Field;
using laplacian_lines::FieldAttribute;
using laplacian_lines::FieldColumn;
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

void write_ply(const TriangleMesh& mesh, const std::string& path) {
    std::ofstream file = open(path);
    file << "ply\nformat ascii 1.0\nelement vertex " << mesh.positions.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
         << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const auto& p : mesh.positions)
        file << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& t : mesh.triangles)
        file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    file.close();  // or a full disk is not noticed
}

template <class Vector>
void write_vector(std::ofstream& file, const Vector& v) {
    file << v.x() << ' ' << v.y() << ' ' << v.z() << ' ';
}

constexpr const char* truth_layout =
    "true_ll_normal:3 true_ll_laplacian_normal:3 true_ll_shape_diagonal:3 "
    "true_ll_shape_off_diagonal:3";

void write_truth(const SurfacePoint& truth, std::ofstream& file) {
    const Eigen::Matrix3d& t = truth.shape_operator;
    write_vector(file, truth.normal);
    write_vector(file, truth.laplacian_normal);
    write_vector(file, t.diagonal());
    file << t(1, 2) << ' ' << t(0, 2) << ' ' << t(0, 1) << '\n';
}

void write_field(const TestMesh& mesh, const Field& field, const std::string& path) {
    const std::vector<FieldColumn> columns = present_columns(field);
    std::ofstream file = open(path);
    file << "# ";
    for (const FieldColumn& column : columns)
        for (const FieldAttribute& attribute : column.attributes)
            if (attribute.floats > 0) file << attribute.name << ':' << attribute.floats << ' ';
    file << truth_layout << '\n';
    for (std::size_t v = 0; v < mesh.mesh.positions.size(); ++v) {
        for (const FieldColumn& column : columns)
            for (std::size_t i = 0; i < std::size_t(column.floats); ++i)
                file << column.read(field)[v * std::size_t(column.floats) + i] << ' ';
        write_truth(mesh.truth.at(v), file);
    }
    file.close();
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
        const TriangleMesh stored = test_meshes::rounded_to_floats(mesh.mesh);  // as it is read
        write_ply(stored, path + ".ply");
        write_field(mesh, laplacian_lines::precompute(stored), path + ".txt");
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "write_reference: %s\n", error.what());
        return 1;
    }
}
