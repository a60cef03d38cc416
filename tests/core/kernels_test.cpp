// SPDX-License-Identifier: GPL-3.0-or-later
// Lines at another kernel size, without another extractor: LineExtractor::laplacian_of(); and which
// sizes a drawing has at which zoom.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/kernel_levels.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/precompute_options.h"

namespace {

using namespace laplacian_lines;

const View kViews[] = {View::perspective({1.5, 1, 2.5}), View::orthographic({0.2, -1, 0.4})};

struct Kernels {
    TriangleMesh mesh;
    Field fine, coarse;

    explicit Kernels(KernelMode mode = KernelMode::Uniform)
        : mesh(test_meshes::mesh_named("bumpy_sphere").mesh) {
        PrecomputeOptions options;
        options.kernel_mode = mode;
        fine = precompute(mesh, options);
        options.kernel_size = 1.6 * fine.scale.kernel_size;
        options.normal_sigma = 1.2;
        coarse = precompute(mesh, options);
    }
    /// What another extractor would be built from.
    Field mixed() const {
        Field field = fine;
        field.laplacian_normals = coarse.laplacian_normals;
        field.kernel_sizes = coarse.kernel_sizes;
        field.scale = coarse.scale;
        return field;
    }
};

LineSet extract(const LineExtractor& extractor, const View& view, const LineStyle& style,
                const KernelLaplacian* laplacian) {
    ExtractionScratch scratch;
    LineSet lines;
    extractor.extract(view, style, scratch, lines, laplacian);
    return lines;
}

std::vector<LineStyle> styles() {
    LineStyle usual = helpers::all_kinds(), whole = usual;
    whole.whole_lines = true;
    whole.least_concavity = -1;
    return {usual, whole};
}

/// But for rounding.
void expect_alike(const LineSet& a, const LineSet& b) {
    ASSERT_EQ(a.lines.size(), b.lines.size());
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        EXPECT_LT((a.points[i].position - b.points[i].position).norm(), 1e-5f) << i;
        EXPECT_NEAR(a.points[i].weight, b.points[i].weight, 1e-3f) << i;
        EXPECT_NEAR(a.points[i].opacity, b.points[i].opacity, 1e-3f) << i;
    }
}

TEST(KernelLaplacian, OfTheSameFieldDrawsTheSameBits) {
    const Kernels kernels;
    const LineExtractor extractor(kernels.mesh, kernels.fine);
    const KernelLaplacian same = extractor.laplacian_of(kernels.mesh, kernels.fine);
    for (const LineStyle& style : styles())
        for (const View& view : kViews)
            EXPECT_TRUE(helpers::same_lines(extract(extractor, view, style, &same),
                                            extract(extractor, view, style, nullptr)));
}

TEST(KernelLaplacian, DrawsAsAnExtractorOfItsOwn) {
    for (const KernelMode mode : {KernelMode::Uniform, KernelMode::Adaptive}) {
        const Kernels kernels(mode);
        const LineExtractor extractor(kernels.mesh, kernels.fine),
            own(kernels.mesh, kernels.mixed());
        const KernelLaplacian coarse = extractor.laplacian_of(kernels.mesh, kernels.coarse);
        for (LineStyle style : styles()) {
            style.shows = {};
            style.shows[LineKind::Laplacian] = style.shows[LineKind::Contour] = true;
            for (const View& view : kViews) {
                const LineSet lines = extract(extractor, view, style, &coarse);
                EXPECT_FALSE(lines.lines.empty());
                expect_alike(lines, extract(own, view, style, nullptr));
                EXPECT_FALSE(helpers::same_lines(lines, extract(extractor, view, style, nullptr)));
            }
        }
    }
}

TEST(KernelLaplacian, OfAnotherMeshIsRefused) {
    const Kernels kernels;
    const LineExtractor extractor(kernels.mesh, kernels.fine);
    const TriangleMesh other = test_meshes::mesh_named("torus").mesh;
    EXPECT_THROW(extractor.laplacian_of(other, precompute(other)), Error);
    EXPECT_THROW(extractor.laplacian_of(kernels.mesh, precompute(other)), Error);
}

TEST(KernelLaplacian, DrawnKernelsAreWithinTheirRange) {
    const TriangleMesh mesh = test_meshes::bumpy_sphere(6, 0.15).mesh;
    const FieldScale scale = measure_scale(mesh);
    const KernelRange range = drawn_kernel_range(scale.mean_edge, scale.diagonal);
    PrecomputeOptions options;
    ASSERT_GT(range.most, 1.2 * range.least);
    for (const double wanted : {1e-6 * range.least, 1.1 * range.least, 1e6 * range.most}) {
        options.drawn_kernel_size = wanted;
        EXPECT_NEAR(measure_scale(mesh, options).kernel_size,
                    std::min(std::max(wanted, range.least), range.most), 1e-9 * range.most);
    }
    EXPECT_EQ(drawn_kernel_range(0.1, 1).most, 0.1);
}

constexpr double mean_edge = 0.002, diagonal = 1;

/// What each level has of the whole.
std::vector<double> shares_of(const KernelLevels& levels, double wanted) {
    std::vector<double> shares(std::size_t(levels.count()), 0);
    for (const LevelShare& share : levels.at(wanted)) {
        EXPECT_EQ(shares.at(std::size_t(share.level)), 0);
        shares.at(std::size_t(share.level)) = share.share;
    }
    return shares;
}

TEST(KernelLevels, GoFromTheLeastToTheLargestThatDrawingsHave) {
    const KernelLevels levels(mean_edge, diagonal);
    EXPECT_DOUBLE_EQ(levels.size(0), mean_edge);
    EXPECT_NEAR(levels.size(levels.count() - 1), 0.04 * diagonal, 1e-12);
    ASSERT_GT(levels.count(), 2);
    const double step = levels.size(1) / levels.size(0);
    EXPECT_LE(step, 1.42);
    for (int level = 2; level < levels.count(); ++level)
        EXPECT_NEAR(levels.size(level) / levels.size(level - 1), step, 1e-12) << "even steps";
}

TEST(KernelLevels, PassIntoEachOtherWithoutAJump) {
    const KernelLevels levels(mean_edge, diagonal);
    const double ratio = 1.001;
    std::size_t both = 0, all = 0;
    std::vector<double> before = shares_of(levels, 0.5 * levels.size(0));
    for (double wanted = 0.5 * levels.size(0); wanted < 2 * 0.04; wanted *= ratio, ++all) {
        const std::vector<double> shares = shares_of(levels, wanted);
        double most = 0;
        for (std::size_t i = 0; i < shares.size(); ++i) {
            EXPECT_LT(std::abs(shares[i] - before[i]), 0.02) << wanted;
            most = std::max(most, shares[i]);
        }
        EXPECT_EQ(most, 1) << "one is there in full";
        both += levels.at(wanted).size() == 2;
        before = shares;
    }
    EXPECT_LT(both, 0.6 * double(all)) << "one redraw outside of the bands";
    EXPECT_GT(both, 0.2 * double(all));
}

TEST(KernelLevels, AreOneWhereTheMeshHasNoOther) {
    const double nan = std::nan("");
    for (const KernelLevels& levels :
         {KernelLevels(0.1, 1), KernelLevels(0.04, 1), KernelLevels(0, 0), KernelLevels(0, 1),
          KernelLevels(nan, 1), KernelLevels()}) {
        EXPECT_EQ(levels.count(), 1);
        for (const double wanted : {0., 0.001, 1., nan}) {
            ASSERT_EQ(levels.at(wanted).size(), 1u);
            EXPECT_EQ(levels.at(wanted)[0].level, 0);
            EXPECT_EQ(levels.at(wanted)[0].share, 1);
        }
    }
    EXPECT_DOUBLE_EQ(KernelLevels(0.1, 1).size(0), 0.1);
}

}  // namespace
