// SPDX-License-Identifier: GPL-3.0-or-later
// The same input gives the same bits, with any number of threads and all instruction sets; redraws
// allocate nothing.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "allocation_hook.h"
#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "with_instruction_set.h"
#include "with_threads.h"

namespace {

using namespace laplacian_lines;
using test_meshes::WithThreads;

Field with_threads(int threads, const TriangleMesh& mesh, const PrecomputeOptions& options) {
    const WithThreads scope(threads);
    return precompute(mesh, options);
}

/// Calls visit(mesh, options) where fields are summed in all ways.
template <class Visit>
void for_each_way(const Visit& visit) {
    PrecomputeOptions other, adaptive, by_grid;
    other.kernel_mode = adaptive.kernel_mode = KernelMode::Adaptive;
    other.gradient_estimator = GradientEstimator::LeastSquares;
    other.normal_smoothing = NormalSmoothing::Bilateral;
    other.curvature_derivatives = adaptive.curvature_derivatives = true;
    adaptive.normal_weighting = NormalWeighting::Max;
    by_grid.kernel_size = 0.2;
    for (const char* name : {"bumpy_sphere", "hills", "three_sheets", "dirty_torus"})
        visit(test_meshes::mesh_named(name).mesh, other);
    // Several ranges of vertices, and parts of the tree built in parallel.
    const TriangleMesh large = test_meshes::torus(240, 120, 0.2).mesh;
    for (const PrecomputeOptions& options : {PrecomputeOptions(), adaptive, by_grid})
        visit(large, options);
}

TEST(Determinism, FieldsDoNotDependOnTheNumberOfThreads) {
    for_each_way([](const TriangleMesh& mesh, const PrecomputeOptions& options) {
        const Field one = with_threads(1, mesh, options);
        for (int threads : {2, 3, 5, 8})
            EXPECT_TRUE(helpers::same_fields(one, with_threads(threads, mesh, options)))
                << threads << " threads";
    });
}

TEST(Determinism, FieldsDoNotDependOnTheInstructionSet) {
    if (narrower_sets().empty()) GTEST_SKIP() << "there is one";
    for_each_way([](const TriangleMesh& mesh, PrecomputeOptions options) {
        for (const double accuracy : {options.accuracy, 1e-6}) {  // summed quickly, in doubles
            options.accuracy = accuracy;
            const Field widest = precompute(mesh, options);
            for (InstructionSet set : narrower_sets()) {
                const WithInstructionSet scope(set);
                EXPECT_TRUE(helpers::same_fields(widest, precompute(mesh, options)))
                    << "instruction set " << int(set) << ", accuracy " << accuracy;
            }
        }
    });
}

TEST(Determinism, SameFieldsAndLinesOfEveryMesh) {
    for (const auto* entries : {&test_meshes::all_entries(), &test_meshes::wild_entries()})
        for (const test_meshes::MeshEntry& entry : *entries) {
            const test_meshes::TestMesh& mesh = entry.get();
            if (mesh.has(test_meshes::kUnusable)) continue;
            PrecomputeOptions options;
            options.curvature_derivatives = true;
            const Field field = with_threads(1, mesh.mesh, options);
            const View view = View::perspective(field.scale.diagonal * Eigen::Vector3d(1, 2, 1.5));
            const LineStyle style = helpers::all_crossings_of_all_kinds();
            const LineSet lines = helpers::extract(LineExtractor(mesh.mesh, field), view, style);
            for (int threads : {1, 2, 3, 8}) {
                EXPECT_TRUE(helpers::same_fields(field, with_threads(threads, mesh.mesh, options)))
                    << mesh << ", " << threads << " threads";
                const WithThreads scope(threads);
                const LineExtractor extractor(mesh.mesh, field);
                EXPECT_TRUE(helpers::same_lines(lines, helpers::extract(extractor, view, style)))
                    << mesh << ", " << threads << " threads";
            }
        }
}

class Extraction : public testing::Test {
protected:
    const test_meshes::AnalyticMesh surface_ = test_meshes::bumpy_sphere(5, 0.15);
    const LineExtractor extractor_{surface_.mesh, helpers::complete_field(surface_.mesh)};
    const std::vector<View> views_ = helpers::random_views(surface_.mesh, 24);
};

TEST_F(Extraction, GivesTheSameLinesWithUsedAndNewScratch) {
    ExtractionScratch used;
    LineSet lines;
    const test_meshes::TestMesh& other = test_meshes::mesh_named("torus");
    const LineExtractor other_extractor(other.mesh, precompute(other.mesh));
    for (const View& view : views_) {
        other_extractor.extract(view, {}, used, lines);
        extractor_.extract(view, {}, used, lines);
        EXPECT_TRUE(helpers::same_lines(lines, helpers::extract(extractor_, view, {})));
    }
}

TEST_F(Extraction, SurvivesTheMeshAndItsField) {
    TriangleMesh mesh = surface_.mesh;
    Field field = precompute(mesh);
    LineExtractor extractor(mesh, field);
    mesh = {};
    field = {};
    LineExtractor moved(std::move(extractor));
    EXPECT_TRUE(helpers::same_lines(helpers::extract(moved, views_[0], {}),
                                    helpers::extract(extractor_, views_[0], {})));
    EXPECT_GT(moved.memory(), 40 * surface_.mesh.positions.size());
}

TEST_F(Extraction, RunsInSeveralThreadsAtOnce) {
    std::vector<LineSet> expected;
    for (const View& view : views_)
        expected.push_back(helpers::extract(extractor_, view, {}));
    std::atomic<int> different{0};
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < 3; ++t)
        threads.emplace_back([&, t] {
            ExtractionScratch scratch;
            LineSet lines;
            for (std::size_t i = 0; i < 3 * views_.size(); ++i) {
                const std::size_t view = (i + 5 * t) % views_.size();
                extractor_.extract(views_[view], {}, scratch, lines);
                different += !helpers::same_lines(lines, expected[view]);
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(different, 0);
}

TEST_F(Extraction, AllocatesNothingInTheSteadyState) {
    for (const LineStyle& style : {LineStyle(), helpers::all_crossings(), helpers::all_kinds()})
        for (int threads : {1, 2, 5}) {
            const WithThreads scope(threads);
            ExtractionScratch scratch;
            LineSet lines;
            const auto turn = [&] {
                for (const View& view : views_)
                    extractor_.extract(view, style, scratch, lines);
            };
            turn();
            const std::size_t before = allocation_hook::count();
            for (int i = 0; i < 3; ++i)  // threads share the work differently each time
                turn();
            EXPECT_EQ(allocation_hook::count(), before) << threads << " threads";
            EXPECT_GT(before, 0u);
        }
}

TEST_F(Extraction, LeavesTheScratchUsableAfterAnError) {
    ExtractionScratch scratch;
    LineSet lines;
    LineStyle bad;
    bad.full_slope = 0;
    EXPECT_THROW(extractor_.extract(views_[0], bad, scratch, lines), std::exception);
    extractor_.extract(views_[0], {}, scratch, lines);
    EXPECT_TRUE(helpers::same_lines(lines, helpers::extract(extractor_, views_[0], {})));
}

}  // namespace
