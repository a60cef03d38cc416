// SPDX-License-Identifier: GPL-3.0-or-later
// Which kernel sizes a drawing has at which zoom.
#include "laplacian_lines/kernel_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "laplacian_lines/precompute_options.h"

using laplacian_lines::KernelLevels;
using laplacian_lines::LevelShare;

namespace {

constexpr double mean_edge = 0.002, diagonal = 1;

/// What each level has of the whole.
std::vector<double> sharesOf(const KernelLevels& levels, double wanted) {
    std::vector<double> shares(std::size_t(levels.count()), 0);
    for (const LevelShare& share : levels.at(wanted)) {
        EXPECT_EQ(shares.at(std::size_t(share.level)), 0);
        shares.at(std::size_t(share.level)) = share.share;
    }
    return shares;
}

TEST(KernelLevels, GoFromTheLeastToTheLargestThatDrawingsHave) {
    const KernelLevels levels(mean_edge, diagonal);
    EXPECT_DOUBLE_EQ(levels.size(0), 2 * mean_edge);
    EXPECT_NEAR(levels.size(levels.count() - 1), 0.04 * diagonal, 1e-12);
    ASSERT_GT(levels.count(), 2);
    const double step = levels.size(1) / levels.size(0);
    EXPECT_LE(step, 1.42);
    for (int level = 2; level < levels.count(); ++level)
        EXPECT_NEAR(levels.size(level) / levels.size(level - 1), step, 1e-12) << "even steps";
}

TEST(KernelLevels, AreTheNearestOnes) {
    const KernelLevels levels(mean_edge, diagonal);
    for (int level = 0; level < levels.count(); ++level) {
        const auto at = levels.at(levels.size(level));
        ASSERT_EQ(at.size(), 1u) << level;
        EXPECT_EQ(at[0].level, level);
        EXPECT_EQ(at[0].share, 1);
    }
    const double middle = std::sqrt(levels.size(0) * levels.size(1));
    for (const auto& [wanted, first] : {std::pair{0.99 * middle, 0}, {1.01 * middle, 1}}) {
        const auto at = levels.at(wanted);
        ASSERT_EQ(at.size(), 2u);
        EXPECT_EQ(at[0].level, first);
        EXPECT_EQ(at[0].share, 1);
        EXPECT_EQ(at[1].level, 1 - first);
        EXPECT_GT(at[1].share, 0.8);
        EXPECT_LT(at[1].share, 1);
    }
}

TEST(KernelLevels, PassIntoEachOtherWithoutAJump) {
    const KernelLevels levels(mean_edge, diagonal);
    const double ratio = 1.001;
    std::size_t both = 0, all = 0;
    std::vector<double> before = sharesOf(levels, 0.5 * levels.size(0));
    for (double wanted = 0.5 * levels.size(0); wanted < 2 * 0.04; wanted *= ratio, ++all) {
        const std::vector<double> shares = sharesOf(levels, wanted);
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

TEST(KernelLevels, StayWithinTheirRange) {
    const KernelLevels levels(mean_edge, diagonal);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double tiny : {-1., 0., 1e-300, 1e-6, std::nan(""), -infinity}) {
        ASSERT_EQ(levels.at(tiny).size(), 1u);
        EXPECT_EQ(levels.at(tiny)[0].level, 0);
    }
    for (const double huge : {1., 1e300, infinity}) {
        ASSERT_EQ(levels.at(huge).size(), 1u);
        EXPECT_EQ(levels.at(huge)[0].level, levels.count() - 1);
    }
}

TEST(KernelLevels, AreOneWhereTheMeshHasNoOther) {
    const double nan = std::nan("");
    for (const KernelLevels& levels :
         {KernelLevels(0.1, 1), KernelLevels(0.02, 1), KernelLevels(0, 0), KernelLevels(0, 1),
          KernelLevels(nan, 1), KernelLevels()}) {
        EXPECT_EQ(levels.count(), 1);
        for (const double wanted : {0., 0.001, 1., nan}) {
            ASSERT_EQ(levels.at(wanted).size(), 1u);
            EXPECT_EQ(levels.at(wanted)[0].level, 0);
            EXPECT_EQ(levels.at(wanted)[0].share, 1);
        }
    }
    EXPECT_DOUBLE_EQ(KernelLevels(0.1, 1).size(0), 0.2);
}

}  // namespace
