// SPDX-License-Identifier: GPL-3.0-or-later
#include "kept_lines.h"

#include <gtest/gtest.h>

namespace {

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
    kept_.forgetAllBut(one_, {});
    EXPECT_FALSE(lines.expired());
    kept_.forgetAllBut(other_, {});
    EXPECT_TRUE(lines.expired());
}

TEST_F(KeptLinesTest, GoWithTheirMeshAndTheirDocument) {
    const auto stays = keep(one_, 1, 10), gone = keep(one_, 3, 10), elsewhere = keep(other_, 3, 10);
    kept_.forgetAllBut(one_, {0, 1, 2});
    EXPECT_FALSE(stays.expired());
    EXPECT_TRUE(gone.expired());
    EXPECT_FALSE(elsewhere.expired());
    kept_.forgetAllBut(other_, {});
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
