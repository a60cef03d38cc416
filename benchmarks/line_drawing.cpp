// SPDX-License-Identifier: GPL-3.0-or-later
// line_drawing [--tolerance PIXELS] [--eyes N] [--subdivide N] [--zoom Z] [--dashed] MESH: what
// OpenGL takes for the lines of a mesh in a view of 1000 x 700, with all their points and with
// those that can be seen; and by how much the pictures differ. Needs a display; by software with
// LIBGL_ALWAYS_SOFTWARE=1.
#include <GL/glew.h>

#include <QGuiApplication>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "drawing_of_lines.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"
#include "midpoint_subdivision.h"
#include "orbit.h"

namespace {

using namespace benchmarks;

struct Arguments {
    DrawingOptions options;
    int subdivisions = 0;
    std::string file;
};

Arguments parse(int argc, char** argv) {
    Arguments result;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const auto number = [&] {
            if (++i == argc) throw std::invalid_argument(argument + " needs a number");
            return std::stod(argv[i]);
        };
        if (argument == "--tolerance")
            result.options.tolerance = number();
        else if (argument == "--eyes")
            result.options.eyes = int(number());
        else if (argument == "--subdivide")
            result.subdivisions = int(number());
        else if (argument == "--zoom")
            result.options.zoom = number();
        else if (argument == "--dashed")
            result.options.is_dashed = true;
        else if (argument == "--pictures" && i + 1 < argc)
            result.options.pictures = argv[++i];
        else
            result.file = argument;
    }
    if (result.file.empty()) throw std::invalid_argument("no mesh is named");
    return result;
}

void print(const char* name, const DrawingFigures& figures) {
    std::printf("%-12s %10.0f %10.2f %10.2f %10.2f\n", name, figures.segments, figures.writing,
                figures.drawing, figures.writing + figures.drawing);
}

void report(const DrawingComparison& result) {
    std::printf("of a view    segments  writing ms drawing ms     both ms\n");
    print("all points", result.all);
    print("simplified", result.simplified);
    std::printf("both : all points %.3f; lines %.0f pixels long; extraction %.2f ms\n",
                (result.simplified.writing + result.simplified.drawing) /
                    (result.all.writing + result.all.drawing),
                result.length, result.extraction);
    std::printf(
        "pictures: greatest difference %d of 255, mean of those that differ %.1f; "
        "pixels that differ by more than 32: %.3f %%, 64: %.4f %%, 128: %.5f %%\n",
        result.greatest_difference, result.mean_difference, 100 * result.above[0],
        100 * result.above[1], 100 * result.above[2]);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Arguments arguments = parse(argc, argv);
        const QGuiApplication program(argc, argv);
        laplacian_lines::TriangleMesh mesh = test_meshes::read_mesh(arguments.file);
        laplacian_lines::Field field = laplacian_lines::precompute(mesh);
        for (int i = 0; i < arguments.subdivisions; ++i)
            subdivide(mesh, field);
        report(compareDrawings(mesh, field, arguments.options));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "line_drawing: %s\n", error.what());
        return 1;
    }
}
