// SPDX-License-Identifier: GPL-3.0-or-later
// Every ErrorCode, with a sentence for the user, and nothing changed.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"
#include "with_threads.h"

namespace {

using namespace laplacian_lines;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const TriangleMesh& small_mesh() {
    return test_meshes::mesh_named("single_triangle").mesh;
}

/// Returns the error's sentence.
std::string expect_error(ErrorCode code, const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        EXPECT_EQ(int(error.code()), int(code)) << error.what();
        const std::string message = error.what();
        EXPECT_GT(message.size(), 15u);
        EXPECT_EQ(message.back(), '.');
        return message;
    }
    ADD_FAILURE() << "no error";
    return {};
}

/// As far as the row's type can hold them.
template <class Options>
std::vector<double> bad_values(const OptionDescription<Options>& row) {
    if (row.kind == OptionKind::Boolean) return {};
    if (row.kind == OptionKind::Choice) return {row.minimum - 1, row.maximum + 1};
    std::vector<double> values = {std::nextafter(row.minimum, -kInfinity), kNaN, -kInfinity,
                                  kInfinity};
    if (row.maximum < 1e300) values.push_back(std::nextafter(row.maximum, kInfinity));
    return values;
}

TEST(InvalidOption, NamesEachPrecomputeOption) {
    for (const auto& row : precompute_option_table())
        for (double value : bad_values(row)) {
            PrecomputeOptions options;
            row.set(options, value);
            for (const auto& call : std::vector<std::function<void()>>{
                     [&] { validate(options); }, [&] { precompute(small_mesh(), options); },
                     [&] { measure_scale(small_mesh(), options); }}) {
                const std::string message = expect_error(ErrorCode::InvalidOption, call);
                EXPECT_NE(message.find(row.label), std::string::npos) << message;
                for (const char* choice : row.choices)
                    EXPECT_NE(message.find(choice), std::string::npos) << message;
            }
        }
}

TEST(InvalidOption, NamesEachStyleOption) {
    const LineExtractor extractor(small_mesh(), precompute(small_mesh()));
    for (const auto& row : line_style_table())
        for (double value : bad_values(row)) {
            LineStyle style;
            row.set(style, value);
            expect_error(ErrorCode::InvalidOption, [&] { validate(style); });
            const std::string message = expect_error(ErrorCode::InvalidOption, [&] {
                helpers::extract(extractor, View::orthographic(Eigen::Vector3d::UnitX()), style);
            });
            EXPECT_NE(message.find(row.label), std::string::npos) << message;
        }
}

TEST(InvalidOption, LimitsThemselvesAreAllowed) {
    for (const auto& row : precompute_option_table())
        for (double value : {row.minimum, row.maximum}) {
            PrecomputeOptions options;
            row.set(options, value);
            EXPECT_NO_THROW(validate(options)) << row.key;
        }
    for (const auto& row : line_style_table())
        for (double value : {row.minimum, row.maximum}) {
            LineStyle style;
            row.set(style, value);
            EXPECT_NO_THROW(validate(style)) << row.key;
        }
}

TEST(InvalidOption, ViewsWithoutAFiniteEye) {
    const LineExtractor extractor(small_mesh(), precompute(small_mesh()));
    for (const View& view :
         {View::orthographic(Eigen::Vector3d::Zero()), View::perspective({0, kNaN, 0}),
          View::perspective({kInfinity, 0, 0}), View::orthographic({0, 0, kInfinity}),
          View{{1, 0, 0}, kNaN}, View{{1, 0, 0}, kInfinity},
          View{{1, 0, 0}, 1, Eigen::Vector3d(0, 0, 0)},
          View{{1, 0, 0}, 1, Eigen::Vector3d(0, kNaN, 1)}})
        expect_error(ErrorCode::InvalidOption,
                     [&] { helpers::extract(extractor, view, LineStyle()); });
}

TEST(InvalidMesh, VertexIndexOutOfRange) {
    const Field field = precompute(small_mesh());
    for (std::uint32_t bad : {3u, 0xffffffffu}) {
        TriangleMesh mesh = small_mesh();
        mesh.triangles.push_back({0, bad, 1});
        const std::string message = expect_error(ErrorCode::InvalidMesh, [&] { precompute(mesh); });
        EXPECT_NE(message.find(std::to_string(bad)), std::string::npos) << message;
        expect_error(ErrorCode::InvalidMesh, [&] { measure_scale(mesh); });
        expect_error(ErrorCode::InvalidMesh, [&] { LineExtractor(mesh, field); });
    }
}

TEST(EmptyMesh, NoTriangleWithAnArea) {
    const TriangleMesh nothing;
    const TriangleMesh cloud{{{0, 0, 0}, {1, 0, 0}}, {}};
    const TriangleMesh needles{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {0, 0, 1}}};
    const TriangleMesh not_finite{{{0, 0, 0}, {1, 0, 0}, {0, kNaN, 0}}, {{0, 1, 2}}};
    for (const TriangleMesh& mesh : {nothing, cloud, needles, not_finite}) {
        expect_error(ErrorCode::EmptyMesh, [&] { precompute(mesh); });
        expect_error(ErrorCode::EmptyMesh, [&] { measure_scale(mesh); });
    }
}

TEST(FieldMismatch, FieldOfAnotherMesh) {
    const Field field = precompute(test_meshes::mesh_named("plane").mesh);
    expect_error(ErrorCode::FieldMismatch, [&] { LineExtractor(small_mesh(), field); });
    Field cut = precompute(small_mesh());
    cut.shape_operators.pop_back();
    expect_error(ErrorCode::FieldMismatch, [&] { LineExtractor(small_mesh(), cut); });
}

std::vector<PrecomputeOptions> slow_options() {
    std::vector<PrecomputeOptions> list(3);
    list[1].gradient_estimator = GradientEstimator::LeastSquares;
    list[2].laplace_operator = LaplaceOperator::Cotangent;
    return list;
}

TEST(Progress, NeverFallsAndCoversEverything) {
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    for (const PrecomputeOptions& options : slow_options()) {
        double last = 0;
        std::set<std::string> stages;
        int calls = 0;
        precompute(mesh, options, [&](double done, const char* stage) {
            EXPECT_GE(done, last);
            EXPECT_LE(done, 1);
            last = done;
            ++calls;
            stages.insert(stage);
            return true;
        });
        EXPECT_EQ(last, 1);
        EXPECT_GE(calls, 5);
        EXPECT_GE(stages.size(), 3u);
    }
}

/// On one thread: of several, the one that reports may get little of the work.
TEST(Progress, MovesThroughAllStepsOfALargerMesh) {
    const TriangleMesh mesh = test_meshes::torus(240, 120, 0.2).mesh;
    const test_meshes::WithThreads scope(1);
    using Clock = std::chrono::steady_clock;
    std::map<std::string, int> calls;
    double last = 0, largest_step = 0, longest_silence = 0;
    Clock::time_point heard = Clock::now();
    precompute(mesh, {}, [&](double done, const char* stage) {
        const Clock::time_point now = Clock::now();
        longest_silence =
            std::max(longest_silence, std::chrono::duration<double>(now - heard).count());
        heard = now;
        largest_step = std::max(largest_step, done - last);
        last = done;
        ++calls[stage];
        return true;
    });
    for (const char* stage :
         {"Preparing the mesh", "Sorting in space", "Computing normals", "Smoothing normals",
          "Estimating curvature tensors", "Computing the Laplacian of the normals"})
        EXPECT_GE(calls[stage], 1) << stage;
    EXPECT_GE(calls["Computing the Laplacian of the normals"], 20);
    EXPECT_LE(largest_step, 0.16);  // the mesh is prepared in one step
    RecordProperty("longest_silence_in_seconds", std::to_string(longest_silence));
}

TEST(Cancelled, AtAnyMomentWithTheInputUntouched) {
    const TriangleMesh mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    TriangleMesh input = mesh;
    for (const PrecomputeOptions& options : slow_options())
        for (double moment : {0.0, 0.05, 0.1, 0.25, 0.4, 0.6, 0.99, 1.0}) {
            bool refused = false, asked_again = false;
            expect_error(ErrorCode::Cancelled, [&] {
                precompute(input, options, [&](double done, const char*) {
                    asked_again |= refused;
                    refused |= done >= moment;
                    return !refused;
                });
            });
            EXPECT_FALSE(asked_again) << "moment " << moment;
        }
    EXPECT_EQ(input.positions, mesh.positions);
    EXPECT_EQ(input.triangles, mesh.triangles);
}

struct Stop {};

TEST(Cancelled, ExceptionsOfTheCallbackPassThrough) {
    const TriangleMesh& mesh = test_meshes::mesh_named("bumpy_sphere").mesh;
    for (double moment : {0.0, 0.15, 0.7})
        EXPECT_THROW(precompute(mesh, {},
                                [&](double done, const char*) {
                                    if (done >= moment) throw Stop();
                                    return true;
                                }),
                     Stop);
}

}  // namespace
