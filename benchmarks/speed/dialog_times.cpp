// SPDX-License-Identifier: GPL-3.0-or-later
// dialog_times FILE [--subdivide N]: what the plugin's part of opening each filter's dialog takes
// on a mesh as MeshLab holds it, its triangles cut in four, N times. Seconds, the best of three.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>

#include "add_layer.h"
#include "drawing_dialog.h"
#include "filter_laplacian_lines.h"
#include "mesh_file.h"
#include "midpoint_subdivision.h"
#include "program.h"
#include "turns.h"

namespace {

using laplacian_lines::TriangleMesh;

double bestSeconds(const std::function<void()>& work) {
    double best = benchmarks::seconds(work);
    for (int i = 0; i < 2; ++i)
        best = std::min(best, benchmarks::seconds(work));
    return best;
}

void timeDialogs(const MeshDocument& document) {
    for (const auto& filter : makeFilters()) {
        RichParameterList list;
        const double seconds =
            bestSeconds([&] { filter->listParameters(document.mm(), list = RichParameterList()); });
        std::printf("%-38s %.4f\n", qUtf8Printable(filter->description().name), seconds);
    }
    const auto fields = [](const QString& label) {
        return label == "Views" ? std::optional<QString>("six") : std::nullopt;
    };
    const double first = bestSeconds([&] { DrawingOutlook().inWords(document, fields); });
    DrawingOutlook outlook;
    outlook.inWords(document, fields);
    const double next = bestSeconds([&] { outlook.inWords(document, fields); });
    std::printf("%-38s %.4f\n%-38s %.4f\n%s\n", "outlook of a drawing of six views", first,
                "the same when a field changes", next,
                qUtf8Printable(outlook.inWords(document, fields).value_or("busy")));
}

}  // namespace

int main(int argc, char** argv) {
    int times = 0;
    return benchmarks::run_program(
        argc, argv, "FILE", {benchmarks::number("--subdivide N", "cuts triangles in four", times)},
        [&](const std::vector<std::string>& files) {
            MeshDocument document;
            {
                TriangleMesh mesh = test_meshes::read_mesh(files.front());
                benchmarks::subdivide(mesh, times);
                addLayer(document, "mesh", mesh);
            }
            std::printf("%d triangles\n", document.mm()->cm.fn);
            timeDialogs(document);
            return true;
        });
}
