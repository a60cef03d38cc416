// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_levels.h"

#include <gtest/gtest.h>

#include <limits>

#include "event_loop.h"
#include "meshlab_host/geometry_stamp.h"
#include "meshlab_host/mesh_conversion.h"
#include "wavy_sheet.h"

using laplacian_lines::DrawnKernel;
using laplacian_lines::LineKind;
using laplacian_lines::LineSet;

namespace {

class ViewLevelsTest : public testing::Test {
protected:
    ViewLevelsTest() {
        makeSheet(mesh_, 100);
        lines_ =
            prepareLines(mesh_, "sheet", meshlab_host::fieldSource(mesh_), [](const QString&) {});
    }

    std::vector<DrawnKernel> demand(double wanted, bool waits = false) {
        return levels_->demand(lines_, mesh_, wanted, &widget_, waits);
    }
    double size(int level) const { return lines_->levels.size(level); }
    /// Processes events until the condition holds.
    template <class Condition>
    static bool becomes(Condition condition) {
        QElapsedTimer clock;
        clock.start();
        while (!condition() && clock.elapsed() < 60000)
            wait(5);
        return condition();
    }
    LineSet extract(const std::vector<DrawnKernel>& kernels) {
        laplacian_lines::ExtractionScratch scratch;
        LineSet others, lines;
        extract_kernels(*lines_->extractor, laplacian_lines::View::orthographic({0.3, 0.4, 1}), {},
                        kernels, scratch, others, lines);
        return lines;
    }

    CMeshO mesh_;
    PreparedLinesPointer lines_;
    CountingWidget widget_;
    int grown_ = 0;
    std::unique_ptr<ViewLevels> levels_ = std::make_unique<ViewLevels>([this] { ++grown_; });
};

TEST_F(ViewLevelsTest, AreComputedAtOnceForThoseWhoWait) {
    ASSERT_GT(lines_->levels.count(), 3);
    const std::size_t before = lines_->bytes;
    const auto kernels = demand(size(2), true);
    ASSERT_EQ(kernels.size(), 1u);
    EXPECT_EQ(kernels[0].size, size(2));
    EXPECT_NE(kernels[0].laplacian, nullptr);
    EXPECT_GT(lines_->bytes, before);
    EXPECT_EQ(lines_->kept_levels.bytes(), kernels[0].laplacian->memory()) << "and no other";
    EXPECT_EQ(demand(size(2), true)[0].laplacian, kernels[0].laplacian) << "once";
}

TEST_F(ViewLevelsTest, ComeFromTheBackgroundAndHaveTheViewRedrawn) {
    const auto first = demand(size(2));
    ASSERT_EQ(first.size(), 1u);
    EXPECT_EQ(first[0].laplacian, nullptr) << "as computed until then";
    ASSERT_TRUE(becomes([&] { return lines_->kept_levels.has(2); }));
    EXPECT_EQ(grown_, 1);
    EXPECT_TRUE(becomes([&] { return widget_.redraws() > 0; }));
    EXPECT_EQ(demand(size(2))[0].size, size(2));
    // The level that is likely next follows.
    ASSERT_TRUE(becomes([&] { return lines_->kept_levels.has(1); }));
    demand(size(2));
    ASSERT_TRUE(becomes([&] { return lines_->kept_levels.has(3); }));
    demand(size(2));
    wait(100);
    EXPECT_EQ(grown_, 3) << "and nothing else";
}

TEST_F(ViewLevelsTest, AreNotComputedOfAMeshThatHasChanged) {
    mesh_.vert[7].P()[2] += Scalarm(0.01);
    demand(size(2));
    wait(200);
    EXPECT_EQ(grown_, 0);
    EXPECT_FALSE(lines_->kept_levels.has(2));
}

TEST_F(ViewLevelsTest, AreGivenUpWithTheirLines) {
    demand(size(2));
    const std::weak_ptr<PreparedLines> watch = lines_;
    lines_.reset();
    EXPECT_TRUE(becomes([&] { return watch.expired(); }));
    // Others can still be computed.
    lines_ = prepareLines(mesh_, "sheet", meshlab_host::fieldSource(mesh_), [](const QString&) {});
    demand(size(2));
    EXPECT_TRUE(becomes([&] { return lines_->kept_levels.has(2); }));
}

TEST_F(ViewLevelsTest, MayEndInTheMiddleOfTheWork) {
    demand(size(2));
    levels_.reset();
    wait(50);
    EXPECT_EQ(grown_, 0);
    EXPECT_EQ(lines_.use_count(), 1) << "nobody works on them";
}

TEST_F(ViewLevelsTest, ThatFailAreTriedOnce) {
    lines_->options.normal_sigma = std::numeric_limits<double>::quiet_NaN();
    demand(size(2));
    ASSERT_TRUE(becomes([&] { return lines_->failed_levels.count(2) > 0; }));
    EXPECT_FALSE(lines_->failed_levels[2].isEmpty());
    EXPECT_EQ(demand(size(2), true)[0].laplacian, nullptr);
}

TEST_F(ViewLevelsTest, TheSecondIsAppendedAndFaded) {
    const double middle = std::sqrt(size(3) * size(4)) * 1.02;
    const auto kernels = demand(middle, true);
    ASSERT_EQ(kernels.size(), 2u);
    const LineSet first = extract({kernels[0]}), both = extract(kernels);
    ASSERT_GT(both.lines.size(), first.lines.size());
    for (std::size_t i = 0; i < first.points.size(); ++i)
        ASSERT_EQ(both.points[i].position, first.points[i].position);
    for (std::size_t i = first.lines.size(); i < both.lines.size(); ++i) {
        EXPECT_EQ(both.lines[i].kind, LineKind::Laplacian) << "other lines are not doubled";
        for (std::uint32_t p = 0; p < both.lines[i].count; ++p)
            EXPECT_LE(both.points[both.lines[i].first + p].opacity, kernels[1].share + 1e-6);
    }
}

}  // namespace
