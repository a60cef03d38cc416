// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_cache.h"

#include <gtest/gtest.h>

#include "event_loop.h"

namespace {

meshlab_host::FieldKey key_of(unsigned number) {
    meshlab_host::FieldKey key;
    key.stamp.hash = number;
    return key;
}

/// The number stands for a geometry.
PreparedLinesPointer lines_of(unsigned number) {
    auto lines = std::make_shared<PreparedLines>();
    lines->key = key_of(number);
    return lines;
}

class LineCacheTest : public testing::Test {
protected:
    /// Assigns new lines; only a weak pointer is left here.
    std::weak_ptr<PreparedLines> assign(LineCache::View view, int mesh, unsigned number) {
        PreparedLinesPointer lines = lines_of(number);
        cache_.assign(view, mesh, lines);
        return lines;
    }

    LineCache cache_;
    const int views_[2] = {};
    const LineCache::View left_ = &views_[0], right_ = &views_[1];
};

TEST_F(LineCacheTest, FindsLinesByTheirContent) {
    assign(left_, 0, 1);
    ASSERT_TRUE(cache_.find(key_of(1)));
    EXPECT_EQ(cache_.find(key_of(1)), cache_.at(left_, 0));
    EXPECT_EQ(cache_.find(key_of(2)), nullptr);
    meshlab_host::FieldKey other_options = key_of(1);
    other_options.options = {0.5};
    EXPECT_EQ(cache_.find(other_options), nullptr);
}

/// MeshLab restarts decorations all the time.
TEST_F(LineCacheTest, FindsWhatIsReleasedUntilTheTurnEnds) {
    const auto lines = assign(left_, 0, 1);
    cache_.release(left_, 0);
    EXPECT_EQ(cache_.at(left_, 0), nullptr);
    ASSERT_TRUE(cache_.find(key_of(1)));
    wait(0);
    EXPECT_TRUE(lines.expired());
    EXPECT_EQ(cache_.find(key_of(1)), nullptr);
}

TEST_F(LineCacheTest, KeepsLinesAsLongAsSomeoneUsesThem) {
    const auto lines = assign(left_, 0, 1);
    cache_.assign(right_, 7, lines.lock());
    cache_.release_view(left_);
    wait(0);
    EXPECT_FALSE(lines.expired());
    cache_.release(right_, 7);
    wait(0);
    EXPECT_TRUE(lines.expired());
}

TEST_F(LineCacheTest, ReleasesMeshesThatAreGone) {
    const auto gone = assign(left_, 2, 1), kept = assign(left_, 3, 2);
    const auto elsewhere = assign(right_, 2, 3);
    cache_.release_all_but(left_, {0, 3, 9});
    wait(0);
    EXPECT_TRUE(gone.expired());
    EXPECT_FALSE(kept.expired());
    EXPECT_FALSE(elsewhere.expired());
}

/// MeshLab does not say which mesh is gone, but restarts all others within the turn.
TEST_F(LineCacheTest, ReleasesWhatIsNotAssignedAgainInTheSameTurn) {
    const auto gone = assign(left_, 0, 1), kept = assign(left_, 1, 2);
    const auto elsewhere = assign(right_, 0, 3);
    wait(0);
    cache_.release_unless_assigned(left_);
    EXPECT_TRUE(cache_.at(left_, 0)) << "not yet";
    cache_.assign(left_, 1, kept.lock());
    wait(0);
    EXPECT_TRUE(gone.expired());
    EXPECT_FALSE(kept.expired());
    EXPECT_FALSE(elsewhere.expired());
    assign(right_, 5, 4);
    wait(0);
    EXPECT_FALSE(kept.expired()) << "said once, done once";
}

TEST_F(LineCacheTest, ChecksGeometryWhereThereAreNoLines) {
    QWidget widget;
    const Eigen::Matrix4d still = Eigen::Matrix4d::Identity(), moved = 2 * still;
    EXPECT_TRUE(cache_.is_check_due(left_, 0, still, &widget));
    assign(left_, 0, 1);
    EXPECT_TRUE(cache_.is_check_due(left_, 0, still, &widget)) << "the first redraw";
    EXPECT_FALSE(cache_.is_check_due(left_, 0, moved, &widget)) << "the camera has moved";
    EXPECT_TRUE(cache_.is_check_due(right_, 0, moved, &widget)) << "another view";
}

class KeptLinesTest : public testing::Test {
protected:
    static constexpr std::size_t most = 100;

    /// New lines of this size; only a weak pointer is left here.
    std::weak_ptr<PreparedLines> keep(KeptLines::Document document, int mesh, std::size_t bytes) {
        auto lines = std::make_shared<PreparedLines>();
        lines->bytes = bytes;
        kept_.keep(document, mesh, lines);
        return lines;
    }

    KeptLines kept_{most};
    const int documents_[2] = {};
    const KeptLines::Document one_ = &documents_[0], other_ = &documents_[1];
};

TEST_F(KeptLinesTest, AreTheLastOnesOfAMesh) {
    const auto before = keep(one_, 0, 10), elsewhere = keep(one_, 1, 10);
    const auto now = keep(one_, 0, 20);
    EXPECT_TRUE(before.expired());
    EXPECT_FALSE(elsewhere.expired());
    EXPECT_FALSE(now.expired());
    EXPECT_EQ(kept_.bytes(), 30u);
}

TEST_F(KeptLinesTest, GoInTheOrderOfTheirUse) {
    const auto first = keep(one_, 0, 40), second = keep(one_, 1, 40);
    kept_.keep(one_, 0, first.lock());
    const auto third = keep(other_, 0, 60);
    EXPECT_FALSE(first.expired()) << "used after the second";
    EXPECT_TRUE(second.expired());
    EXPECT_FALSE(third.expired());
    EXPECT_EQ(kept_.bytes(), most);
}

TEST_F(KeptLinesTest, AreNeverMoreThanTheyMay) {
    const auto small = keep(one_, 0, 10), large = keep(one_, 1, most + 1);
    EXPECT_TRUE(large.expired());
    EXPECT_LE(kept_.bytes(), most);
    const auto as_large_as_possible = keep(one_, 2, most);
    EXPECT_FALSE(as_large_as_possible.expired());
}

TEST_F(KeptLinesTest, CountOnceWhereMeshesShareThem) {
    const auto lines = keep(one_, 0, 80);
    kept_.keep(one_, 1, lines.lock());
    kept_.keep(other_, 5, lines.lock());
    EXPECT_EQ(kept_.bytes(), 80u);
    kept_.forget_all_but(one_, {});
    EXPECT_FALSE(lines.expired());
    kept_.forget_all_but(other_, {});
    EXPECT_TRUE(lines.expired());
}

TEST_F(KeptLinesTest, GoWithTheirMeshAndTheirDocument) {
    const auto stays = keep(one_, 1, 10), gone = keep(one_, 3, 10), elsewhere = keep(other_, 3, 10);
    kept_.forget_all_but(one_, {0, 1, 2});
    EXPECT_FALSE(stays.expired());
    EXPECT_TRUE(gone.expired());
    EXPECT_FALSE(elsewhere.expired());
    kept_.forget_all_but(other_, {});
    EXPECT_TRUE(elsewhere.expired());
}

TEST_F(KeptLinesTest, AreGivenBackToThoseWhoLackMemory) {
    EXPECT_FALSE(kept_.drop());
    const auto lines = keep(one_, 0, 10);
    EXPECT_TRUE(kept_.drop());
    EXPECT_TRUE(lines.expired());
    EXPECT_EQ(kept_.bytes(), 0u);
}

}  // namespace
