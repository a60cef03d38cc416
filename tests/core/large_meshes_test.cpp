// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes on which a careless step would be quadratic. Tests of more than a second or two only run
// with LAPLACIAN_LINES_LARGE=1.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"
#include "wild_case.h"

namespace {

using namespace laplacian_lines;

struct LargeMesh {
    const char* name;
    TriangleMesh (*make)();
    double kernel_size = 0;
    bool refused = false;
};

TriangleMesh tetrahedra(int count) {
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector3d p(i % 37, i / 37 % 41, i / (37 * 41));
        const Eigen::Vector3d x(0.4, 0, 0), y(0, 0.4, 0), z(0, 0, 0.4);
        test_meshes::append(
            mesh, {{p, p + x, p + y, p + z}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
    }
    return mesh;
}

/// A bumpy torus; test_meshes::torus() would spend longer on its truth.
TriangleMesh ring(int columns, int rows) {
    return test_meshes::grid_mesh({columns, rows, true, true}, [](double u, double v) {
        const double a = 2 * M_PI * u, b = 2 * M_PI * v;
        const double thickness = 0.4 + 0.03 * std::sin(9 * a) * std::sin(4 * b);
        const double radius = 1 + thickness * std::cos(b);
        return Eigen::Vector3d(radius * std::cos(a), radius * std::sin(a), thickness * std::sin(b));
    });
}

const LargeMesh kMeshes[] = {
    {"TenMillionTriangles", [] { return ring(3200, 1600); }},
    {"KernelOfAThousandMeshes", [] { return ring(800, 400); }, 3000},
    {"MillionTrianglesAtOneVertex", [] { return test_meshes::star(1000000); }},
    {"MillionVerticesAtTwoPoints", [] { return test_meshes::on_a_line(1000000, 2); }, 0, true},
    {"MillionVerticesOnALine", [] { return test_meshes::on_a_line(1000000, 1000000); }, 0, true},
    {"HundredThousandTrianglesOnOneEdge", [] { return test_meshes::book(100000); }},
    {"HundredThousandTrianglesWithin40Degrees", [] { return test_meshes::book(100000, 0.6); }},
    {"HundredThousandPieces", [] { return tetrahedra(100000); }},
};

class Large : public testing::TestWithParam<LargeMesh> {};

TEST_P(Large, MeshIsDoneOrRefused) {
    if (!std::getenv("LAPLACIAN_LINES_LARGE")) GTEST_SKIP() << "LAPLACIAN_LINES_LARGE=1 runs it";
    const TriangleMesh mesh = GetParam().make();
    PrecomputeOptions options;
    options.kernel_size = GetParam().kernel_size;
    try {
        const Field field = precompute(mesh, options);
        EXPECT_EQ(wild::violation(mesh, field), "");
        const View view = View::perspective(field.scale.diagonal * Eigen::Vector3d(1, 2, 1.5));
        EXPECT_EQ(wild::violation(helpers::extract(LineExtractor(mesh, field), view, {})), "");
        EXPECT_FALSE(GetParam().refused);
    } catch (const Error& error) {
        EXPECT_TRUE(GetParam().refused) << error.what();
    }
}
INSTANTIATE_TEST_SUITE_P(Meshes, Large, testing::ValuesIn(kMeshes),
                         [](const auto& info) { return info.param.name; });

// ---- sums that would take too long are refused before they begin ----

std::string refusal(const TriangleMesh& mesh, const PrecomputeOptions& options) {
    try {
        precompute(mesh, options);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::TooCostly) << error.what();
        return error.what();
    }
    return "not refused";
}

TEST(CostlySum, IsRefusedWithWhatToDo) {
    // All vertices are near each other.
    const TriangleMesh star = test_meshes::star(600000);
    PrecomputeOptions balls;
    balls.gradient_estimator = GradientEstimator::LeastSquares;
    EXPECT_NE(refusal(star, balls).find("Gradient Radius"), std::string::npos);
}

}  // namespace
