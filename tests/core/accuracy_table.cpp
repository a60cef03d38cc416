// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the tables of docs/accuracy.md: errors of the field and of lines. With an argument, those
// of lines alone.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <functional>
#include <string>

#include "helpers.h"
#include "kind_truth.h"
#include "laplacian_lines/precompute.h"
#include "reference_field.h"

namespace {

using namespace laplacian_lines;
using test_meshes::AnalyticMesh;

struct Family {
    const char* name;
    std::function<AnalyticMesh(int level)> generate;
};

const std::vector<Family>& families() {
    static const std::vector<Family> list = {
        {"sphere", [](int l) { return test_meshes::sphere(l + 3); }},
        {"ellipsoid", [](int l) { return test_meshes::ellipsoid(l + 3); }},
        {"bumpy sphere, jitter .15", [](int l) { return test_meshes::bumpy_sphere(l + 4, .15); }},
        {"torus", [](int l) { return test_meshes::torus(40 << l, 20 << l); }},
        {"torus, jitter .25", [](int l) { return test_meshes::torus(40 << l, 20 << l, .25); }},
    };
    return list;
}

constexpr int kLevels = 4;

/// √h = 1.5 √(ē · ē of the coarsest): shrinks more slowly than ē, as convergence needs.
void print_convergence(const char* title,
                       const std::function<double(const AnalyticMesh&, double)>& error) {
    std::printf(
        "\n%s\n\n| surface | coarse | 4 x | 16 x | 64 x triangles |\n|---|---|---|---|---|\n",
        title);
    for (const Family& family : families()) {
        std::printf("| %s |", family.name);
        double coarsest = 0;
        for (int level = 0; level < kLevels; ++level) {
            const AnalyticMesh surface = family.generate(level);
            const double edge = reference::mean_edge(surface.mesh);
            if (level == 0) coarsest = edge;
            std::printf(" %.2g |", error(surface, 1.5 * std::sqrt(edge * coarsest)));
        }
        std::printf("\n");
    }
}

double laplacian_error(const AnalyticMesh& surface, const PrecomputeOptions& options) {
    return helpers::laplacian_error(precompute(surface.mesh, options), surface.truth);
}

/// `size`: the option for √h.
void print_kernel_sizes(const char* title, double PrecomputeOptions::*size) {
    std::printf("\nError of Δn by kernel size, %s\n\n| surface |", title);
    const double factors[] = {1, 2, 3, 5, 10};
    for (double f : factors)
        std::printf(" √h = %g ē |", f);
    std::printf("\n|---|---|---|---|---|---|\n");
    for (const Family& family : families()) {
        const AnalyticMesh surface = family.generate(kLevels - 1);
        const double edge = reference::mean_edge(surface.mesh);
        std::printf("| %s |", family.name);
        for (double f : factors) {
            PrecomputeOptions options;
            options.*size = f * edge;
            std::printf(" %.2g |", laplacian_error(surface, options));
        }
        std::printf("\n");
    }
}

void print_sums() {
    std::printf("\nRelative error of Eq. 2 in fast sums against plain ones\n\n| accuracy |");
    const double factors[] = {1, 2, 4, 9};
    for (double f : factors)
        std::printf(" √h = %g ē |", f);
    std::printf("\n|---|---|---|---|---|\n");
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    const auto normals = reference::normals(mesh, NormalWeighting::Area);
    for (double accuracy : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        std::printf("| %g |", accuracy);
        for (double f : factors) {
            PrecomputeOptions options = helpers::plain_options(f * reference::mean_edge(mesh));
            options.accuracy = accuracy;
            const auto expected = reference::laplacian(
                mesh, normals, std::vector<double>(normals.size(), options.kernel_size), false);
            std::printf(" %.2g |", helpers::relative_error(
                                       precompute(mesh, options).laplacian_normals, expected));
        }
        std::printf("\n");
    }
}

void print_kinds() {
    constexpr int levels = 3;
    std::printf(
        "\nLines of each kind: mean (largest) distance to the true ones, %% of D\n\n| kind | "
        "surface "
        "| coarse | 4 x | 16 x triangles | order of the mean |\n|---|---|---|---|---|---|\n");
    for (const reference::Refinement& surface : reference::refinements()) {
        const AnalyticMesh fine = surface.generate(levels);
        std::deque<reference::KindTruth> truths;
        for (int level = 0; level < levels; ++level)
            truths.emplace_back(surface.generate(level).mesh, fine, surface.border);
        for (const LineKind kind : reference::true_kinds) {
            double first = 0, last = 0;
            std::string cells;
            for (const reference::KindTruth& truth : truths) {
                const reference::LineDistance found = truth.over_views(kind);
                char cell[60];
                std::snprintf(cell, sizeof cell, " %.2g (%.2g) |", 100 * found.mean,
                              100 * found.largest);
                cells += cell;
                (&truth == &truths.front() ? first : last) = found.mean;
            }
            if (first == 0 || last == 0) continue;  // the surface has no such lines
            std::printf("| %s | %s |%s %.1f |\n", describe(kind).many, surface.name, cells.c_str(),
                        std::log2(first / last) / (levels - 1));
        }
    }
}

}  // namespace

int main(int argc, char**) {
    if (argc > 1) {  // lines alone
        print_kinds();
        return 0;
    }
    PrecomputeOptions options;
    print_convergence("Relative error of Δn, default options",
                      [&](const AnalyticMesh& s, double size) {
                          options.kernel_size = size;
                          return laplacian_error(s, options);
                      });
    options.normal_weighting = NormalWeighting::Max;
    options.normal_smoothing = NormalSmoothing::None;
    print_convergence("Relative error of Δn, N. Max's normals, not smoothed",
                      [&](const AnalyticMesh& s, double size) {
                          options.kernel_size = size;
                          return laplacian_error(s, options);
                      });
    print_convergence("Relative error of S, triangle fit", [](const AnalyticMesh& s, double) {
        return helpers::shape_error(precompute(s.mesh), s.truth);
    });
    print_convergence("Relative error of S, least squares", [](const AnalyticMesh& s, double) {
        PrecomputeOptions options;
        options.gradient_estimator = GradientEstimator::LeastSquares;
        return helpers::shape_error(precompute(s.mesh, options), s.truth);
    });
    print_kernel_sizes("default options", &PrecomputeOptions::kernel_size);
    print_kernel_sizes("levels of drawings", &PrecomputeOptions::drawn_kernel_size);
    print_sums();
    print_kinds();
}
