// SPDX-License-Identifier: GPL-3.0-or-later
// Both ways of summing the kernel against plain sums in double precision, and the choice between
// them, by internal headers.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <tuple>

#include "field/belkin_laplacian.h"
#include "field/field_steps.h"
#include "field/shape_operators.h"
#include "helpers.h"
#include "laplacian_lines/error.h"
#include "reference_field.h"

namespace {

using namespace laplacian_lines;
using Vectors = std::vector<Eigen::Vector3d>;

TriangleMesh noisy(TriangleMesh mesh, double part_of_edge) {
    std::mt19937 random(4);
    const double size = part_of_edge * reference::mean_edge(mesh);
    for (Eigen::Vector3d& p : mesh.positions)
        for (double& x : p)
            x += size * (double(random()) / double(std::mt19937::max()) - 0.5);
    return mesh;
}

/// Two parallel sheets, bent so that Δn is not zero on them.
TriangleMesh bent_wall() {
    TriangleMesh mesh = test_meshes::parallel_sheets(72, 0.12);
    for (Eigen::Vector3d& p : mesh.positions)
        p.z() += 0.2 * std::sin(2 * p.x() + p.y());
    return mesh;
}

/// Cells that grow tenfold along both axes.
TriangleMesh graded_hills() {
    return test_meshes::grid_mesh({56, 56, false, false, 0.15},
                                  [](double u, double v) {
                                      return test_meshes::hills_point(std::exp(2.3 * u) / 5 - 1,
                                                                      std::exp(2.3 * v) / 5 - 1);
                                  })
        .mesh;
}

TriangleMesh mesh_for(const std::string& name) {
    if (name == "noisy_torus") return noisy(test_meshes::torus(80, 40).mesh, 0.3);
    if (name == "offset_torus")
        return test_meshes::moved(test_meshes::torus(80, 40, 0.2).mesh, {4000, -3000, 1000});
    if (name == "bent_wall") return bent_wall();
    if (name == "graded_hills") return graded_hills();
    return test_meshes::mesh_named(name).mesh;
}

/// Inputs of belkin_laplacian(), in the mesh's order up to the sorting in space.
struct Prepared {
    Prepared(const TriangleMesh& mesh, double size_in_edges, KernelMode mode)
        : prepared(prepare_mesh(mesh, Cuts::Left)), tree(sort_in_space(prepared)) {
        const Progress silent;
        const StageProgress stage(silent, 0, 1, "");
        const VertexRanges ranges(prepared);
        normals = vertex_normals(prepared, ranges, NormalWeighting::Area, stage);
        shape_operators = fit_triangles(prepared, ranges, normals, stage);
        smooth_over_one_rings(prepared, ranges, normals, 1, stage, shape_operators);
        kernel_sizes = relative_kernel_sizes(prepared, ranges, mode, stage);
        for (float& size : kernel_sizes)
            size *= float(size_in_edges * prepared.mean_edge);
    }

    Vectors laplacian(const BelkinOptions& options, const Progress& progress = {}) const {
        return belkin_laplacian(prepared, tree, normals, kernel_sizes, shape_operators, options,
                                StageProgress(progress, 0, 1, "test"));
    }

    SummationCosts costs(double accuracy) const {
        BelkinOptions options;
        options.accuracy = accuracy;
        return summation_costs(prepared, tree, belkin_kernel(kernel_sizes, options),
                               grid_resolution(accuracy, 1));
    }

    PreparedMesh prepared;
    SpatialTree tree;
    Vectors normals;
    ShapeOperators shape_operators;
    std::vector<float> kernel_sizes;
};

double facing(double cosine) {
    const double s = (1 + cosine) / 2;
    return s * s * (3 - 2 * s);
}

/// As belkin_laplacian() documents it, pair by pair.
Eigen::Vector3d plain_laplacian(const Prepared& m, std::size_t p, const BelkinOptions& options) {
    const double h = double(m.kernel_sizes[p]) * m.kernel_sizes[p], pi = std::acos(-1.0);
    const Eigen::Vector3d& n = m.normals[p];
    Eigen::Vector3d difference = Eigen::Vector3d::Zero(), moment = difference;
    double mass = 0;
    for (std::size_t q = 0; q < m.normals.size(); ++q) {
        const Eigen::Vector3d d = m.prepared.positions[q] - m.prepared.positions[p];
        const double w = m.prepared.masses[q] * std::exp(-d.squaredNorm() / (4 * h)) *
                         (options.skip_opposite_sheet ? facing(n.dot(m.normals[q])) : 1);
        mass += w;
        moment += w * d;
        difference += w * (m.normals[q] - n);
    }
    Eigen::Vector3d result = difference / (4 * pi * h * h);
    if (!options.correct_borders) return result;
    moment = (moment - n * n.dot(moment)) / (4 * pi * h * h);
    const SymmetricTensor& s = m.shape_operators[p];
    result -= s * moment / (1 + h * s.squaredNorm());
    return result + n * n.dot(result) * (1 / std::max(mass / (4 * pi * h), 0.2) - 1);
}

constexpr std::size_t every_vertex = 7;  // that is looked at

Vectors plain_sample(const Prepared& m, const BelkinOptions& options) {
    Vectors sample;
    for (std::size_t p = 0; p < m.normals.size(); p += every_vertex)
        sample.push_back(plain_laplacian(m, p, options));
    return sample;
}

/// Over the sample.
double error(const Vectors& laplacian, const Vectors& sample) {
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < sample.size(); ++i) {
        difference += (laplacian[i * every_vertex] - sample[i]).squaredNorm();
        size += sample[i].squaredNorm();
    }
    return std::sqrt(difference / size);
}

const char* name_of(Summation summation) {
    return summation == Summation::Grid ? "grid" : "direct";
}

using Case = std::tuple<const char*, double>;  // mesh, √h in mean edges

std::string case_name(const testing::TestParamInfo<Case>& info) {
    return std::string(std::get<0>(info.param)) + "_" +
           std::to_string(int(std::get<1>(info.param)));
}

class Guarantee : public testing::TestWithParam<Case> {
protected:
    void expect_accuracies(KernelMode mode) const {
        const Prepared m(mesh_for(std::get<0>(GetParam())), std::get<1>(GetParam()), mode);
        for (bool corrections : {false, true}) {
            const Vectors sample =
                plain_sample(m, {1e-3, corrections, corrections, Summation::Fastest});
            for (Summation summation : {Summation::Grid, Summation::Direct})
                for (double accuracy : {1e-2, 1e-3, 1e-5}) {
                    const BelkinOptions options = {accuracy, corrections, corrections, summation};
                    // 4e-6: rounding of the direct sum. 2 %: compensated twice where the kernel
                    // holds the whole mesh.
                    EXPECT_LT(error(m.laplacian(options), sample), 1.02 * accuracy + 4e-6)
                        << name_of(summation) << ", accuracy " << accuracy
                        << (corrections ? ", corrected" : "");
                }
        }
    }
};

TEST_P(Guarantee, UniformKernel) {
    expect_accuracies(KernelMode::Uniform);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, Guarantee,
    testing::Combine(testing::Values("noisy_torus", "offset_torus", "sphere_jittered",
                                     "bumpy_sphere", "hills", "half_torus", "cube", "bent_wall"),
                     testing::Values(2.0, 5.0, 10.0, 20.0)),
    case_name);

class AdaptiveGuarantee : public Guarantee {};

TEST_P(AdaptiveGuarantee, AdaptiveKernel) {
    expect_accuracies(KernelMode::Adaptive);
}

INSTANTIATE_TEST_SUITE_P(Meshes, AdaptiveGuarantee,
                         testing::Combine(testing::Values("graded_hills", "noisy_torus"),
                                          testing::Values(2.0, 5.0)),
                         case_name);

TEST(SummationChoice, FollowsThePredictedCost) {
    // Fine enough for each way to win somewhere.
    const TriangleMesh mesh = test_meshes::torus(300, 150, 0.2).mesh;
    double last_direct = 0;
    for (double size : {1.0, 2.0, 5.0, 10.0, 20.0}) {
        const Prepared m(mesh, size, KernelMode::Uniform);
        const SummationCosts costs = m.costs(1e-3);
        EXPECT_GT(costs.direct, 1.5 * last_direct) << size;  // the sources grow with h
        last_direct = costs.direct;
        EXPECT_EQ(costs.fastest(), size < 3 ? Summation::Direct : Summation::Grid) << size;
        // The bits of the method named, and not of the other.
        BelkinOptions options;
        const Vectors chosen = m.laplacian(options);
        options.summation = costs.fastest();
        EXPECT_TRUE(m.laplacian(options) == chosen) << size;
        if (size != 2) continue;
        options.summation = Summation::Grid;
        EXPECT_FALSE(m.laplacian(options) == chosen);
    }
}

TEST(SummationChoice, GridGetsDearerWithAccuracy) {
    const Prepared m(test_meshes::torus(120, 60).mesh, 3, KernelMode::Uniform);
    EXPECT_GT(m.costs(1e-3).grid, m.costs(1e-2).grid);
    EXPECT_GT(m.costs(1e-5).grid, 1.5 * m.costs(1e-3).grid);
}

TEST(SummationChoice, AGridFarLargerThanTheMeshIsNotBuilt) {
    // 27 balls, a few thousand kernels apart.
    const Prepared m(test_meshes::mesh_named("scattered_spheres").mesh, 0.001, KernelMode::Uniform);
    EXPECT_EQ(m.costs(1e-3).grid, std::numeric_limits<double>::infinity());
}

TEST(GridSums, ProgressNeverFallsAndCancelsAtOnce) {
    const Prepared m(graded_hills(), 3, KernelMode::Adaptive);
    BelkinOptions options;
    options.summation = Summation::Grid;
    double last = 0;
    int calls = 0;
    m.laplacian(options, [&](double done, const char*) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1);
        last = done;
        ++calls;
        return true;
    });
    EXPECT_GT(calls, 20);
    EXPECT_GT(last, 0.9);
    for (int stop : {1, calls / 2, calls}) {
        int count = 0;
        EXPECT_THROW(m.laplacian(options, [&](double, const char*) { return ++count < stop; }),
                     Error);
        EXPECT_EQ(count, stop);
    }
}

}  // namespace
