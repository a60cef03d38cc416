// SPDX-License-Identifier: GPL-3.0-or-later
// extraction_table [OPTIONS] MESH...
// The program behind ./bench: a table of the times of redraws in the default style, beside plain
// ways to draw less.
//   --precompute       also what is computed once
//   --no-redraws       only that
//   --subdivide [L-]N  the last mesh also subdivided L (1) to N times; it is left out if L is given
//   --rounds N, --seconds S   a mesh takes 3 rounds, and then up to N (20) and about S (20) seconds
//   --json FILE        all figures
// Files are OBJ or PLY, plain or with .gz.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "extraction_times.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"
#include "midpoint_subdivision.h"
#include "orbit.h"
#include "precompute_times.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;

const Section kSize{"size", "Size"};
const Section kGrowth{"growth", "x in time ∝ triangles^x, from a quarter of the triangles"};

struct Arguments {
    bool precompute = false, redraws = true;
    int first_level = 0, last_level = 0;  ///< subdivisions of the last mesh
    Turns turns;
    std::string json;
    std::vector<std::string> files;
};

double number(const std::string& option, const char* text, double least) {
    char* end = nullptr;
    const double value = text ? std::strtod(text, &end) : 0;
    if (!text || end == text || *end || !(value >= least))
        throw std::invalid_argument(option + " needs a number, at least " +
                                    std::to_string(int(least)));
    return value;
}

void set_levels(const char* text, Arguments& arguments) {
    const char* dash = text ? std::strchr(text, '-') : nullptr;
    if (dash)
        arguments.first_level = int(number("--subdivide", std::string(text, dash).c_str(), 1));
    arguments.last_level =
        int(number("--subdivide", dash ? dash + 1 : text, arguments.first_level));
}

Arguments parse(int argc, char** argv) {
    Arguments result;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--precompute") {
            result.precompute = true;
        } else if (argument == "--no-redraws") {
            result.precompute = true;
            result.redraws = false;
        } else if (argument == "--subdivide") {
            set_levels(argv[++i], result);
        } else if (argument == "--rounds") {
            result.turns.most_rounds = int(number(argument, argv[++i], 1));
            result.turns.least_rounds = std::min(3, result.turns.most_rounds);
        } else if (argument == "--seconds") {
            result.turns.budget = number(argument, argv[++i], 0);
        } else if (argument == "--json") {
            if (++i == argc) throw std::invalid_argument("--json needs the name of a file");
            result.json = argv[i];
        } else if (argument[0] == '-') {
            throw std::invalid_argument("unknown option " + argument);
        } else {
            result.files.push_back(argument);
        }
    }
    if (result.files.empty()) throw std::invalid_argument("no mesh is named");
    return result;
}

MeshFigures measure(const std::string& name, const TriangleMesh& mesh, const Field& field,
                    const Arguments& arguments) {
    std::fprintf(stderr, "measuring %s\n", name.c_str());
    MeshFigures figures{name};
    figures.add(kSize, "triangles", "triangles", double(mesh.triangles.size()));
    figures.add(kSize, "vertices", "vertices", double(mesh.positions.size()));
    figures.add(kSize, "kernel_in_mean_edges", "√h in mean edges",
                field.scale.kernel_size / field.scale.mean_edge);
    if (arguments.precompute) add_precompute(mesh, field.scale.kernel_size, figures);
    if (arguments.redraws) add_extraction(mesh, field, arguments.turns, figures);
    return figures;
}

/// The exponents of growth from a mesh to the same with four times the triangles.
void add_growth(const MeshFigures& coarse, MeshFigures& fine) {
    for (const auto& [key, text] : {std::pair{"lines", "Laplacian lines and contours"},
                                    {"plain_contours", "plain contours"}}) {
        const double before = coarse.value(kExtraction, key), now = fine.value(kExtraction, key);
        if (before > 0 && now > 0)
            fine.add(kGrowth, key, text, std::log(now / before) / std::log(4.0));
    }
}

/// The mesh at all its levels of subdivision.
void measure_levels(const std::string& file, int first, int last, const Arguments& arguments,
                    std::vector<MeshFigures>& meshes) {
    TriangleMesh mesh = test_meshes::read_mesh(file);
    Field field = precompute(mesh);
    for (int level = 0; level <= last; ++level) {
        if (level > 0) subdivide(mesh, field);
        if (level < first) continue;
        const std::string suffix = level > 0 ? " × " + std::to_string(1 << 2 * level) : "";
        meshes.push_back(measure(test_meshes::mesh_name(file) + suffix, mesh, field, arguments));
        if (level > first) add_growth(meshes[meshes.size() - 2], meshes.back());
    }
}

std::vector<MeshFigures> measure_all(const Arguments& arguments) {
    std::vector<MeshFigures> meshes;
    for (const std::string& file : arguments.files) {
        const bool last = &file == &arguments.files.back();
        measure_levels(file, last ? arguments.first_level : 0, last ? arguments.last_level : 0,
                       arguments, meshes);
    }
    return meshes;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Arguments arguments = parse(argc, argv);
        const std::vector<MeshFigures> meshes = measure_all(arguments);
        std::printf("%s\n\n%s", machine_text().c_str(), markdown_table(meshes).c_str());
        if (!arguments.json.empty() &&
            !(std::ofstream(arguments.json) << json_report(meshes) << std::flush))
            throw std::runtime_error("cannot write " + arguments.json);
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr,
                     "extraction_table: %s\nextraction_table [--precompute] [--no-redraws] "
                     "[--subdivide [L-]N] [--rounds N] [--seconds S] [--json FILE] MESH...\n",
                     error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "extraction_table: %s\n", error.what());
        return 1;
    }
}
