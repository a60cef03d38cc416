// SPDX-License-Identifier: GPL-3.0-or-later
// Building what lines are extracted and hidden by: progress rises from 0 to 1 in small steps, and
// the callback can cancel.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "registry.h"
#include "with_threads.h"

namespace {

using namespace laplacian_lines;

struct Builder {
    const char* name;
    std::function<void(const TriangleMesh&, const Field&, const Progress&)> build;
};

const Builder builders[] = {
    {"LineExtractor", [](const TriangleMesh& mesh, const Field& field,
                         const Progress& progress) { LineExtractor(mesh, field, progress); }},
    {"LineVisibility", [](const TriangleMesh& mesh, const Field&,
                          const Progress& progress) { LineVisibility(mesh, progress); }},
};

/// 230,400 triangles: more than Eigen's trees have at most.
const TriangleMesh& large_mesh() {
    static const TriangleMesh mesh = test_meshes::torus(480, 240, 0.2).mesh;
    return mesh;
}

const Field& field_of_large_mesh() {
    static const Field field = precompute(large_mesh());
    return field;
}

class BuildingProgress : public testing::TestWithParam<Builder> {
protected:
    void build(const Progress& progress) const {
        GetParam().build(large_mesh(), field_of_large_mesh(), progress);
    }
};

TEST_P(BuildingProgress, RisesFromZeroToOne) {
    for (const int threads : {1, 3}) {
        const test_meshes::WithThreads scope(threads);
        std::vector<double> reports;
        build([&](double done, const char* stage) {
            EXPECT_STRNE(stage, "");
            reports.push_back(done);
            return true;
        });
        ASSERT_FALSE(reports.empty());
        EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
        EXPECT_EQ(reports.front(), 0);
        EXPECT_EQ(reports.back(), 1);
    }
}

/// On one thread: of several, the one that reports may get little of the work.
TEST_P(BuildingProgress, MovesInSmallSteps) {
    const test_meshes::WithThreads scope(1);
    double last = 0, largest_step = 0;
    build([&](double done, const char*) {
        largest_step = std::max(largest_step, done - last);
        last = done;
        return true;
    });
    EXPECT_LE(largest_step, 0.4);
}

TEST_P(BuildingProgress, EndsAtOnceWhenCancelled) {
    for (const double moment : {0., 0.1, 0.2, 0.3, 0.5, 0.8, 1.}) {
        SCOPED_TRACE(moment);
        bool refused = false, asked_again = false;
        try {
            build([&](double done, const char*) {
                asked_again |= refused;
                refused |= done >= moment;
                return !refused;
            });
            ADD_FAILURE() << "not cancelled";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::Cancelled);
        }
        EXPECT_FALSE(asked_again);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, BuildingProgress, testing::ValuesIn(builders),
                         [](const auto& info) { return info.param.name; });

}  // namespace
