// SPDX-License-Identifier: GPL-3.0-or-later
// For ./bench --instructions: with --prepare, writes a mesh and its field; then, in callgrind,
// redraws it for some eyes by the extractor and the plain methods, with a dump named after each.
// Prints for each the redraws, the vertices, and the triangles that zeros pass in all redraws. In
// two runs, since valgrind takes minutes for the field.
#include <valgrind/callgrind.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "laplacian_lines/field_columns.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"
#include "program.h"
#include "redraws.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;

constexpr std::size_t kEveryEye = 5;  // of the orbit

/// Written and read in one order by Archive.
template <class Archive>
void transfer(Archive&& archive, TriangleMesh& mesh, Field& field) {
    archive(mesh.positions);
    archive(mesh.triangles);
    for (const FieldColumn& column : field_columns) {
        const std::size_t floats = std::size_t(column.floats), count = floats * column.size(field);
        std::vector<float> values(column.read(field), column.read(field) + count);
        archive(values);
        column.resize(field, values.size() / floats);
        std::copy(values.begin(), values.end(), column.write(field));
    }
    std::vector<FieldScale> scale = {field.scale};
    archive(scale);
    field.scale = scale.at(0);
}

void prepare(const std::string& file, const std::string& mesh_file) {
    std::ofstream out(file, std::ios::binary);
    TriangleMesh mesh = test_meshes::read_mesh(mesh_file);
    PrecomputeOptions options;
    options.curvature_derivatives = true;
    Field field = precompute(mesh, options);
    transfer(
        [&](const auto& values) {
            const std::size_t count = values.size();
            out.write(reinterpret_cast<const char*>(&count), sizeof count);
            out.write(reinterpret_cast<const char*>(values.data()),
                      std::streamsize(count * sizeof values[0]));
        },
        mesh, field);
    if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

void read(const std::string& file, TriangleMesh& mesh, Field& field) {
    std::ifstream in(file, std::ios::binary);
    transfer(
        [&](auto& values) {
            std::size_t count = 0;
            in.read(reinterpret_cast<char*>(&count), sizeof count);
            values.resize(count);
            in.read(reinterpret_cast<char*>(values.data()),
                    std::streamsize(count * sizeof values[0]));
            if (!in) throw std::runtime_error("cannot read " + file);
        },
        mesh, field);
}

/// 0 where not counted.
std::size_t passed_triangles(const std::string& key, const Redraws::Crossings& crossings) {
    if (key.find("plain_laplacian") == 0) return crossings.laplacian;
    if (key == "plain_contours") return crossings.contour;
    const bool is_both = key.find("lines") == 0 || key == "default_style";
    return is_both ? crossings.laplacian + crossings.contour : 0;
}

void count(const Contender& contender, Redraws& redraws, std::size_t vertices) {
    std::size_t eyes = 0, triangles = 0;
    contender.run(0);  // allocates
    for (std::size_t eye = 0; eye < redraws.view_count(); eye += kEveryEye) {
        CALLGRIND_START_INSTRUMENTATION;
        contender.run(eye);
        CALLGRIND_STOP_INSTRUMENTATION;
        ++eyes;
        triangles += passed_triangles(contender.key, redraws.crossings(eye));
    }
    CALLGRIND_DUMP_STATS_AT(contender.key.c_str());
    std::printf("%s\t%s\t%zu\t%zu\t%zu\n", contender.key.c_str(), contender.text.c_str(), eyes,
                vertices, triangles);
}

void count_all(const std::string& file) {
    TriangleMesh mesh;
    Field field;
    read(file, mesh, field);
    Redraws redraws(mesh, field);
    for (const auto& contenders : {redraws.fast(), redraws.kinds(), redraws.plain()})
        for (const Contender& contender : contenders)
            if (contender.key != "lines_two_threads")
                count(contender, redraws, mesh.positions.size());
}

}  // namespace

int main(int argc, char** argv) {
    std::string prepared;
    const std::vector<Option> options = {
        text("--prepare FILE", "takes what is needed of the mesh", prepared)};
    return run_program(argc, argv, "MESH|FILE", options, [&](const auto& files) {
        if (prepared.empty())
            count_all(files[0]);
        else
            prepare(prepared, files[0]);
        return true;
    });
}
