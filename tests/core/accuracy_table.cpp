// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the tables of docs/accuracy.md: how far the field is from the truth.
#include <cstdio>
#include <functional>

#include "helpers.h"
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

double laplacian_error(const AnalyticMesh& surface, double kernel_size, PrecomputeOptions options) {
    options.kernel_size = kernel_size;
    return helpers::laplacian_error(precompute(surface.mesh, options), surface.truth);
}

void print_kernel_sizes() {
    std::printf("\nError of Δn by kernel size, default options\n\n| surface |");
    const double factors[] = {1, 2, 3, 5, 10};
    for (double f : factors)
        std::printf(" √h = %g ē |", f);
    std::printf("\n|---|---|---|---|---|---|\n");
    for (const Family& family : families()) {
        const AnalyticMesh surface = family.generate(kLevels - 1);
        const double edge = reference::mean_edge(surface.mesh);
        std::printf("| %s |", family.name);
        for (double f : factors)
            std::printf(" %.2g |", laplacian_error(surface, f * edge, {}));
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

}  // namespace

int main() {
    print_convergence(
        "Relative error of Δn, default options",
        [](const AnalyticMesh& s, double size) { return laplacian_error(s, size, {}); });
    print_convergence("Relative error of Δn, N. Max's normals, not smoothed",
                      [](const AnalyticMesh& s, double size) {
                          PrecomputeOptions options;
                          options.normal_weighting = NormalWeighting::Max;
                          options.normal_smoothing = NormalSmoothing::None;
                          return laplacian_error(s, size, options);
                      });
    print_convergence("Relative error of S, triangle fit", [](const AnalyticMesh& s, double) {
        return helpers::shape_error(precompute(s.mesh), s.truth);
    });
    print_convergence("Relative error of S, least squares", [](const AnalyticMesh& s, double) {
        PrecomputeOptions options;
        options.gradient_estimator = GradientEstimator::LeastSquares;
        return helpers::shape_error(precompute(s.mesh, options), s.truth);
    });
    print_kernel_sizes();
    print_sums();
}
