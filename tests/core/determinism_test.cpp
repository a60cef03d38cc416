// SPDX-License-Identifier: GPL-3.0-or-later
// The same input gives the same bits, with any number of threads and all instruction sets; redraws
// allocate nothing.
#include <gtest/gtest.h>

#include <thread>

#include "allocation_hook.h"
#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "system/simd_sets.h"
#include "with_threads.h"

namespace {

using namespace laplacian_lines;
using test_meshes::WithThreads;

/// Restores the set of before.
class WithInstructionSet {
public:
    explicit WithInstructionSet(InstructionSet set) { EXPECT_TRUE(use_instruction_set(set)); }
    ~WithInstructionSet() { use_instruction_set(before_); }
    WithInstructionSet(const WithInstructionSet&) = delete;
    WithInstructionSet& operator=(const WithInstructionSet&) = delete;

private:
    const InstructionSet before_ = instruction_set();
};

/// What the processor and the build have but for the widest, which is in use.
std::vector<InstructionSet> narrower_sets() {
    std::vector<InstructionSet> sets;
    for (int set = 0; set < int(instruction_set()); ++set)
        sets.push_back(InstructionSet(set));
    return sets;
}

Field with_threads(int threads, const TriangleMesh& mesh, const PrecomputeOptions& options) {
    const WithThreads scope(threads);
    return precompute(mesh, options);
}

/// Calls visit(mesh, options) where fields are summed in all ways.
template <class Visit>
void for_each_way(const Visit& visit) {
    PrecomputeOptions other, exact, by_grid;
    other.gradient_estimator = GradientEstimator::LeastSquares;
    other.curvature_derivatives = exact.curvature_derivatives = true;
    other.normal_sigma = 1;
    exact.accuracy = 1e-4;
    by_grid.kernel_size = 0.2;
    for (const char* name : {"hills", "three_sheets", "dirty_torus"})
        visit(test_meshes::mesh_named(name).mesh, other);
    // Several ranges of vertices, and parts of the tree built in parallel.
    const TriangleMesh large = test_meshes::torus(200, 100, 0.2).mesh;
    for (const PrecomputeOptions& options : {PrecomputeOptions(), exact, by_grid})
        visit(large, options);
}

TEST(Determinism, FieldsDoNotDependOnTheNumberOfThreads) {
    for_each_way([](const TriangleMesh& mesh, const PrecomputeOptions& options) {
        const Field one = with_threads(1, mesh, options);
        for (int threads : {2, 5})
            EXPECT_TRUE(helpers::same_fields(one, with_threads(threads, mesh, options)))
                << threads << " threads";
    });
}

TEST(Determinism, FieldsDoNotDependOnTheInstructionSet) {
    if (narrower_sets().empty()) GTEST_SKIP() << "there is one";
    for_each_way([](const TriangleMesh& mesh, PrecomputeOptions options) {
        for (const double accuracy :
             {options.accuracy, 1e-6}) {  // the options' own, and the finest
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

std::vector<LineStyle> styles() {
    LineStyle usual, whole = helpers::all_kinds(), all = helpers::all_crossings_of_all_kinds();
    whole.whole_lines = true;
    return {usual, whole, all};
}

TEST(Determinism, LinesDoNotDependOnTheNumberOfThreads) {
    const TriangleMesh large = test_meshes::bumpy_sphere(6, 0.15).mesh;  // many chunks of clusters
    for (const TriangleMesh& mesh : {large, test_meshes::mesh_named("flipped_torus").mesh,
                                     test_meshes::mesh_named("three_sheets").mesh}) {
        const Field field = helpers::complete_field(mesh);
        const std::vector<View> views = helpers::random_views(mesh, 4);
        const auto lines_on = [&](int threads) {
            const WithThreads scope(threads);
            const LineExtractor extractor(mesh, field);
            std::vector<LineSet> lines;
            for (const View& view : views)
                for (const LineStyle& style : styles())
                    lines.push_back(helpers::extract(extractor, view, style));
            ExtractionScratch scratch;
            const LineStyle style = styles().front();
            lines.push_back(extract_on_surface(extractor, views[0], style, scratch));
            const LineVisibility visibility(mesh);
            lines.push_back(visibility.parts(views[0], {lines.back()}, {style.shows}).seen);
            return lines;
        };
        const std::vector<LineSet> one = lines_on(1);
        for (const int threads : {1, 4}) {
            const std::vector<LineSet> others = lines_on(threads);
            for (std::size_t i = 0; i < one.size(); ++i)
                EXPECT_TRUE(helpers::same_lines(one[i], others[i])) << threads << " threads";
        }
    }
}

TEST(InstructionSets, GiveTheSameBits) {
    if (narrower_sets().empty()) GTEST_SKIP() << "there is one";
    for (const char* name :
         {"bumpy_sphere", "half_torus", "three_sheets", "flipped_torus", "cube"}) {
        const TriangleMesh& mesh = test_meshes::mesh_named(name).mesh;
        const LineExtractor extractor(mesh, helpers::complete_field(mesh));
        for (const View& view : helpers::random_views(mesh, 12))
            for (const LineStyle& style : styles()) {
                const LineSet best = helpers::extract(extractor, view, style);
                for (const InstructionSet set : narrower_sets()) {
                    const WithInstructionSet scope(set);
                    EXPECT_TRUE(helpers::same_lines(best, helpers::extract(extractor, view, style)))
                        << name << ", instruction set " << int(set);
                }
            }
    }
}

class Extraction : public testing::Test {
protected:
    const test_meshes::AnalyticMesh surface_ = test_meshes::bumpy_sphere(5, 0.15);
    const LineExtractor extractor_{surface_.mesh, helpers::complete_field(surface_.mesh)};
    const std::vector<View> views_ = helpers::random_views(surface_.mesh, 12);
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

/// Also what is found on first use.
TEST_F(Extraction, RunsInSeveralThreadsAtOnce) {
    const LineStyle style = helpers::all_kinds();
    const LineExtractor shared(surface_.mesh, helpers::complete_field(surface_.mesh));
    std::vector<std::vector<LineSet>> found(4);
    std::vector<std::thread> threads;
    for (std::vector<LineSet>& lines : found)
        threads.emplace_back([&] {
            for (const View& view : views_)
                lines.push_back(helpers::extract(shared, view, style));
        });
    for (std::thread& thread : threads)
        thread.join();
    for (std::size_t i = 0; i < views_.size(); ++i)
        for (const std::vector<LineSet>& lines : found)
            EXPECT_TRUE(
                helpers::same_lines(lines[i], helpers::extract(extractor_, views_[i], style)));
}

TEST_F(Extraction, AllocatesNothingInTheSteadyState) {
    LineStyle whole;  // with hairpins, which any thread may come to
    whole.whole_lines = true;
    whole.least_concavity = -1;
    for (const LineStyle& style :
         {LineStyle(), helpers::all_crossings(), helpers::all_kinds(), whole})
        for (int threads : {1, style.whole_lines ? 1 : 4}) {
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

/// As if the field had had them from the start.
TEST_F(Extraction, CanBeGivenDerivativesLater) {
    Field field = precompute(surface_.mesh);
    LineExtractor extractor(surface_.mesh, field);
    const LineStyle style = helpers::all_kinds();
    const LineSet without = helpers::extract(extractor, views_[0], style);
    EXPECT_THROW(extractor.add_derivatives(surface_.mesh, field), Error) << "it has none";
    add_curvature_derivatives(surface_.mesh, field);
    EXPECT_THROW(extractor.add_derivatives(test_meshes::icosphere(1), field), Error);
    EXPECT_TRUE(helpers::same_lines(helpers::extract(extractor, views_[0], style), without));
    extractor.add_derivatives(surface_.mesh, field);
    EXPECT_FALSE(helpers::same_lines(helpers::extract(extractor, views_[0], style), without));
    for (const View& view : views_)
        EXPECT_TRUE(helpers::same_lines(helpers::extract(extractor, view, style),
                                        helpers::extract(extractor_, view, style)));
}

TEST_F(Extraction, LeavesTheScratchUsableAfterAnError) {
    ExtractionScratch scratch;
    LineSet lines;
    extractor_.extract(views_[1], helpers::all_kinds(), scratch, lines);
    LineStyle bad;
    bad.full_slope = 0;
    EXPECT_THROW(extractor_.extract(views_[0], bad, scratch, lines), Error);
    extractor_.extract(views_[0], {}, scratch, lines);
    EXPECT_TRUE(helpers::same_lines(lines, helpers::extract(extractor_, views_[0], {})));
}

}  // namespace
