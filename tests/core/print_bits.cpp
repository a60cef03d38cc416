// SPDX-License-Identifier: GPL-3.0-or-later
// print_bits [MESH...]: hashes of test meshes, their fields and lines of all kinds, to compare
// processors. Without names, all.
#include <cinttypes>
#include <cstdio>

#include "helpers.h"
#include "laplacian_lines/field_columns.h"

namespace {

using namespace laplacian_lines;

/// FNV-1a.
class Hash {
public:
    void add(const void* data, std::size_t bytes) {
        for (std::size_t i = 0; i < bytes; ++i)
            value_ = (value_ ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3;
    }
    template <class Number>
    void add(const Number& number) {
        add(&number, sizeof number);
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

std::uint64_t hash_of(const TriangleMesh& mesh) {
    Hash hash;
    for (const Eigen::Vector3d& p : mesh.positions)
        hash.add(p.data(), 3 * sizeof(double));
    for (const Triangle& triangle : mesh.triangles)
        hash.add(triangle);
    return hash.value();
}

std::uint64_t hash_of(const Field& field) {
    Hash hash;
    for (const FieldColumn& column : kFieldColumns)
        hash.add(column.read(field),
                 column.size(field) * std::size_t(column.floats) * sizeof(float));
    return hash.value();
}

void add_lines(const LineSet& lines, Hash& hash) {
    static_assert(sizeof(LinePoint) == 6 * sizeof(float));
    hash.add(lines.points.data(), lines.points.size() * sizeof(LinePoint));
    for (const Polyline& line : lines.lines) {
        hash.add(line.count);
        hash.add(line.kind);
        hash.add(line.closed);
        for (float number : {line.strength, line.length, line.slope})
            hash.add(number);
    }
}

std::uint64_t hash_of_lines(const TriangleMesh& mesh, const Field& field) {
    const LineExtractor extractor(mesh, field);
    Hash hash;
    for (const Eigen::Vector3d& eye : {Eigen::Vector3d(1, 2, 1.5), Eigen::Vector3d(-2, 0.25, 0.5),
                                       Eigen::Vector3d(0.125, -1, 3)})
        for (const View& view :
             {View::perspective(field.scale.diagonal * eye), View::orthographic(eye)})
            for (const LineStyle& style :
                 {helpers::all_kinds(), helpers::all_crossings_of_all_kinds()})
                add_lines(helpers::extract(extractor, view, style), hash);
    return hash.value();
}

void print_bits(const test_meshes::TestMesh& mesh) {
    const Field field = helpers::complete_field(mesh.mesh);
    std::printf("%s: mesh %016" PRIx64 ", field %016" PRIx64 ", lines %016" PRIx64 "\n",
                mesh.name.c_str(), hash_of(mesh.mesh), hash_of(field),
                hash_of_lines(mesh.mesh, field));
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i)
        print_bits(test_meshes::mesh_named(argv[i]));
    if (argc > 1) return 0;
    for (const std::string& name : test_meshes::mesh_names())
        print_bits(test_meshes::mesh_named(name));
}
