// SPDX-License-Identifier: GPL-3.0-or-later
// What takes long tells how far it is, and can be cancelled.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "with_threads.h"

namespace {

using namespace laplacian_lines;

const TriangleMesh& mesh() {
    static const TriangleMesh mesh = test_meshes::torus(240, 120, 0.2).mesh;
    return mesh;
}
const Field& field() {
    static const Field field = helpers::complete_field(mesh());
    return field;
}

void compute(GradientEstimator estimator, LaplaceOperator laplace, const Progress& progress) {
    PrecomputeOptions options;
    options.gradient_estimator = estimator;
    options.laplace_operator = laplace;
    precompute(mesh(), options, progress);
}

struct Work {
    const char* name;
    std::function<void(const Progress&)> run;
    double largest_step;  ///< measured, and a little more: that of the longest part without reports
};
const Work kAllWork[] = {
    {"Field",
     [](const Progress& progress) {
         compute(GradientEstimator::TriangleFit, LaplaceOperator::Belkin, progress);
     },
     0.16},
    {"LeastSquaresAndCotangents",
     [](const Progress& progress) {
         compute(GradientEstimator::LeastSquares, LaplaceOperator::Cotangent, progress);
     },
     0.41},
    {"Derivatives",
     [](const Progress& progress) {
         Field copy = field();
         add_curvature_derivatives(mesh(), copy, progress);
     },
     0.41},
    {"LineExtractor", [](const Progress& progress) { LineExtractor(mesh(), field(), progress); },
     0.4},
    {"LineVisibility", [](const Progress& progress) { LineVisibility(mesh(), progress); }, 0.4},
    {"Look",
     [](const Progress& progress) {
         static const LineVisibility visibility(mesh());
         (void)visibility.visible_lines(View::orthographic({1, 2, 3}), {}, {}, progress);
     },
     0.21},
};

class InProgress : public testing::TestWithParam<Work> {};
INSTANTIATE_TEST_SUITE_P(Of, InProgress, testing::ValuesIn(kAllWork),
                         [](const auto& info) { return info.param.name; });

/// On one thread in steps of at most `largest_step`: of several, the one that reports may get
/// little of the work.
TEST_P(InProgress, RisesFromZeroToOne) {
    for (const int threads : {1, 3}) {
        const test_meshes::WithThreads scope(threads);
        std::vector<double> reports;
        GetParam().run([&](double done, const char* stage) {
            EXPECT_STRNE(stage, "");
            reports.push_back(done);
            return true;
        });
        ASSERT_FALSE(reports.empty());
        EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
        EXPECT_EQ(reports.front(), 0);
        EXPECT_EQ(reports.back(), 1);
        for (std::size_t i = 1; threads == 1 && i < reports.size(); ++i)
            EXPECT_LE(reports[i] - reports[i - 1], GetParam().largest_step);
    }
}

TEST_P(InProgress, IsNotAskedAgainOnceCancelled) {
    for (const double moment : {0., 0.1, 0.3, 0.6, 0.9, 1.}) {
        bool refused = false, asked_again = false;
        try {
            GetParam().run([&](double done, const char*) {
                asked_again |= refused;
                refused |= done >= moment;
                return !refused;
            });
            ADD_FAILURE() << "not cancelled";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::Cancelled);
        }
        EXPECT_FALSE(asked_again) << moment;
    }
}

TEST(Progress, CancelledDerivativesLeaveTheField) {
    const Field before = precompute(mesh());
    for (const double moment : {0., 0.3, 0.9, 1.}) {
        Field field = before;
        EXPECT_THROW(add_curvature_derivatives(
                         mesh(), field, [&](double done, const char*) { return done < moment; }),
                     Error);
        EXPECT_TRUE(helpers::same_fields(field, before)) << moment;
    }
}

}  // namespace
