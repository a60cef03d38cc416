// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of each kind under refinement against those of the smooth surface. Figures:
// docs/accuracy.md.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fixed/ridge_candidates.h"
#include "helpers.h"
#include "kind_truth.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using reference::KindTruth;
using reference::LineDistance;
using reference::Refinement;

class KindsOnSurface : public testing::TestWithParam<Refinement> {};

INSTANTIATE_TEST_SUITE_P(Surfaces, KindsOnSurface, testing::ValuesIn(reference::refinements()),
                         [](const auto& info) {
                             std::string name = info.param.name;
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

TEST_P(KindsOnSurface, AreNearerTheTrueLinesTheFinerTheMesh) {
    const auto fine = GetParam().generate(2);
    const KindTruth coarse(GetParam().generate(0).mesh, fine, GetParam().border),
        finer(GetParam().generate(1).mesh, fine, GetParam().border);
    int compared = 0;
    for (const LineKind kind : reference::true_kinds) {
        const LineDistance before = coarse.over_views(kind), now = finer.over_views(kind);
        if (before.length < 1) continue;
        // Hess I(g, g) grows with the cube of ∇I, and changes sign late where that is small.
        const double least_gain = kind == LineKind::PhoticExtremum ? 0.95 : 0.65;
        EXPECT_LT(now.mean, least_gain * before.mean) << describe(kind).key;
        EXPECT_LT(now.mean, kind == LineKind::Contour ? 0.0015 : 0.011) << describe(kind).key;
        ++compared;
    }
    EXPECT_GT(compared, 0);
}

/// On a torus seen from above the true lines are known.
TEST(TrueField, GivesTheContoursOfATorusFromAbove) {
    const auto torus = test_meshes::torus(96, 48);
    const Field field = reference::true_field(torus, measure_scale(torus.mesh));
    LineStyle style = helpers::only(LineKind::Contour);
    style.exact_outlines = false;
    style.line_smoothing = 0;
    const LineSet lines = helpers::extract(LineExtractor(torus.mesh, field),
                                           View::orthographic(Eigen::Vector3d::UnitZ()), style);
    ASSERT_EQ(lines.lines.size(), 2u);
    for (const LinePoint& p : lines.points)
        EXPECT_NEAR(std::abs(p.position.head<2>().norm() - 1), 0.4, 2e-3);
}

/// The largest curvature of an ellipsoid is largest across the rim of its shortest axis.
TEST(Ridges, OfAnEllipsoidConvergeToItsRim) {
    // Keeps mesh edges off planes of symmetry, where errors cancel.
    const auto turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
    double before = 1;
    for (const int level : {4, 5, 6}) {
        TriangleMesh mesh = test_meshes::icosphere(level);
        for (Eigen::Vector3d& p : mesh.positions)
            p = (turn * p).cwiseProduct(Eigen::Vector3d(1, 0.8, 0.2));
        const ExtractorData data = build_extractor_data(mesh, helpers::complete_field(mesh));
        const auto found = find_ridge_candidates(data, place_clusters(data), kConvexCrest);
        double sum = 0;
        int points = 0;
        for (const LinePoint& p : found.lines.points) {
            if (std::abs(p.position.z()) > 0.1) continue;  // other planes may have crests
            sum += std::abs(p.position.z());
            ++points;
        }
        ASSERT_GT(points, 50);
        EXPECT_LT(sum / points, 0.7 * before) << "level " << level;
        before = sum / points;
    }
    EXPECT_LT(before, 0.003);
}

}  // namespace
