// SPDX-License-Identifier: GPL-3.0-or-later
// extraction_instructions MESH
// What ./bench --instructions runs in callgrind: redraws of the mesh for some eyes, by the
// extractor and by the plain ways. One dump for each of them, named after it. Prints, for each, the
// number of redraws, of vertices, and of triangles that lines of the functions pass in all redraws.
#include <valgrind/callgrind.h>

#include <cstdio>

#include "laplacian_lines/precompute.h"
#include "mesh_file.h"
#include "redraws.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;

constexpr std::size_t kEveryEye = 5;  // of the orbit

std::size_t passed_triangles(const std::string& key, const Redraws::Crossings& crossings) {
    if (key.find("plain_laplacian") == 0) return crossings.laplacian;
    if (key == "plain_contours") return crossings.contour;
    if (key == "suggestive_contours") return crossings.suggestive;
    return crossings.laplacian + crossings.contour;
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

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "extraction_instructions MESH\n");
        return 2;
    }
    try {
        const TriangleMesh mesh = test_meshes::read_mesh(argv[1]);
        const Field field = precompute(mesh);
        Redraws redraws(mesh, field);
        for (const auto& contenders : {redraws.fast(), redraws.plain()})
            for (const Contender& contender : contenders)
                if (contender.key != "lines_two_threads")
                    count(contender, redraws, mesh.positions.size());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "extraction_instructions: %s\n", error.what());
        return 1;
    }
}
