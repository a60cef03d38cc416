// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of each kind under refinement against the right ones of the smooth surface: those of a fine
// mesh with the true field.
#include <gtest/gtest.h>

#include "helpers.h"

namespace {

using namespace laplacian_lines;
using test_meshes::AnalyticMesh;

/// Distances both ways, from what is clearly above the thresholds to anything in the other drawing,
/// even below them.
struct Distance {
    double mean = 0, length = 0;  ///< D; length: of the lines that were measured
};

class KindTruth {
public:
    /// `fine` is of the same surface. What is as near to the planes x, y = ±1 as `border` is left
    /// out.
    KindTruth(const TriangleMesh& mesh, const AnalyticMesh& fine, double border)
        : border_(border),
          field_(helpers::complete_field(mesh)),
          found_(mesh, field_),
          truth_(fine.mesh, helpers::true_field(fine, field_.scale)) {}

    Distance distance(LineKind kind) const {
        constexpr double kClear = 1.5;  // times a threshold, or its inverse
        const Eigen::Vector3d direction = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
        Distance distance;
        for (const View& view : {View::perspective(0.7 * field_.scale.diagonal * direction),
                                 View::orthographic(direction)}) {
            const auto lines = [&](const LineExtractor& extractor, double factor) {
                return helpers::extract(extractor, view, style(kind, factor));
            };
            add(lines(found_, kClear), lines(truth_, 1 / kClear), distance);
            add(lines(truth_, kClear), lines(found_, 1 / kClear), distance);
        }
        if (distance.length > 0) distance.mean /= distance.length;
        return distance;
    }

private:
    /// Nothing makes lines fade, end or move. Slopes grow with the third power of the kernel's
    /// size, the strength of demarcating curves with the second: thresholds follow, so that both
    /// meshes draw the same lines.
    LineStyle style(LineKind kind, double factor) const {
        constexpr double usual = 0.1;  // D; with a kernel of this size, thresholds are the defaults
        const double size = field_.scale.kernel_size / field_.scale.diagonal / usual;
        LineStyle style = helpers::only(kind);
        style.fading = style.line_smoothing = style.end_length = style.contour_clearance = 0;
        style.exact_outlines = style.single_strokes = false;
        style.apparent_curvature = 3 * factor;  // the default is for less gentle surfaces
        style.demarcation *= factor * size * size;
        for (double* const threshold :
             {&style.gradient_threshold, &style.strength_threshold, &style.shortest_line})
            *threshold *= factor;
        for (double* const threshold :
             {&style.segment_slope, &style.line_slope, &style.suggestive_slope,
              &style.apparent_slope, &style.photic_slope})
            *threshold *= factor * size * size * size;
        return style;
    }

    void add(const LineSet& lines, const LineSet& others, Distance& distance) const {
        const double d = field_.scale.diagonal;
        for (const Polyline& line : lines.lines)
            for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
                const Eigen::Vector3d a = lines.position(lines.points[i - 1]),
                                      b = lines.position(lines.points[i]);
                const double length = (b - a).norm() / d;
                if (border_ > 0 && b.head<2>().cwiseAbs().maxCoeff() > 1 - border_) continue;
                const double away =
                    others.lines.empty() ? 1 : helpers::distance_to_lines(b, others) / d;
                distance.mean += away * length;
                distance.length += length;
            }
    }

    const double border_;
    const Field field_;
    const LineExtractor found_, truth_;
};

struct TestSurface {
    const char* name;
    AnalyticMesh (*generate)(int level);  ///< each level has four times the triangles of the last
    int kinds;                            ///< that have lines of more than D there
    double border = 0;
};
class KindsOnSurface : public testing::TestWithParam<TestSurface> {};
INSTANTIATE_TEST_SUITE_P(
    Surfaces, KindsOnSurface,
    testing::Values(
        TestSurface{"torus", [](int l) { return test_meshes::torus(48 << l, 24 << l); }, 4},
        TestSurface{"bumpy_sphere", [](int l) { return test_meshes::bumpy_sphere(l + 4); }, 7},
        TestSurface{"hills", [](int l) { return test_meshes::hills(40 << l); }, 6, 0.2}),
    [](const auto& info) { return info.param.name; });

TEST_P(KindsOnSurface, AreNearerTheTrueLinesTheFinerTheMesh) {
    const AnalyticMesh fine = GetParam().generate(2);
    const KindTruth coarse(GetParam().generate(0).mesh, fine, GetParam().border),
        finer(GetParam().generate(1).mesh, fine, GetParam().border);
    int compared = 0;
    for (const LineKindDescription& row : kLineKinds) {
        // ridges_test.cpp has that of ridges and valleys; borders and creases are the mesh's edges
        const bool has_truth =
            !helpers::lies_on_the_surface(row.kind) || row.kind == LineKind::DemarcatingCurve;
        if (!has_truth) continue;
        const Distance before = coarse.distance(row.kind), now = finer.distance(row.kind);
        if (before.length < 1) continue;  // too few to measure
        EXPECT_GT(now.length, 1) << row.key;
        // Photic extrema are zeros of Hess I(g, g), g = ∇I, of third order in the shading: where
        // this is faint, their places converge slowly.
        const double least_gain = row.kind == LineKind::PhoticExtremum ? 0.95 : 0.65;
        EXPECT_LT(now.mean, least_gain * before.mean) << row.key;
        EXPECT_LT(now.mean, row.kind == LineKind::Contour ? 0.0015 : 0.011) << row.key;
        ++compared;
    }
    EXPECT_EQ(compared, GetParam().kinds);
}

}  // namespace
