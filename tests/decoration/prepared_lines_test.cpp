// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared_lines.h"

#include <gtest/gtest.h>

#include "laplacian_lines/line_mixture.h"
#include "wavy_sheet.h"

namespace {

using meshlab_host::fieldSource;
using meshlab_host::withDerivatives;

class PreparedLinesTest : public testing::Test {
protected:
    PreparedLinesTest() { makeSheet(mesh_, 30); }

    laplacian_lines::LineSet linesOf(const PreparedLines& prepared) {
        laplacian_lines::LineStyle style;
        style.shows = laplacian_lines::all_kinds();
        laplacian_lines::ExtractionScratch scratch;
        laplacian_lines::LineSet lines;
        prepared.extractor->extract(laplacian_lines::View::orthographic({0.3, 0.2, 1}), style,
                                    scratch, lines);
        return lines;
    }
    std::function<void(const QString&)> say() {
        return [this](const QString& line) { said_ << line; };
    }

    CMeshO mesh_;
    QStringList said_;
};

TEST_F(PreparedLinesTest, GetDerivativesWithoutBeingPreparedAgain) {
    const auto source = fieldSource(mesh_);
    const PreparedLinesPointer lines = prepareLines(mesh_, "sheet", source, say());
    const PreparedLinesPointer whole = prepareLines(mesh_, "sheet", withDerivatives(source), say());
    EXPECT_FALSE(lines->has_derivatives);
    EXPECT_TRUE(whole->has_derivatives);
    EXPECT_FALSE(lines->key < whole->key || whole->key < lines->key) << "they are found alike";
    EXPECT_NE(linesOf(*lines).points.size(), linesOf(*whole).points.size());

    const auto surface = lines->surface;
    said_.clear();
    addDerivatives(*lines, mesh_, "sheet", source, say());
    EXPECT_TRUE(lines->has_derivatives);
    EXPECT_EQ(lines->lack, "");
    EXPECT_EQ(lines->surface, surface);
    EXPECT_EQ(linesOf(*lines).points.size(), linesOf(*whole).points.size());
    EXPECT_EQ(lines->bytes, whole->bytes) << "the field is not kept any longer";
    EXPECT_EQ(said_.filter("default options").size(), 0);
    EXPECT_EQ(said_.filter("also need").size(), 1);
}

/// Fails because the mesh is another one.
TEST_F(PreparedLinesTest, StayAsTheyAreWithoutDerivatives) {
    const auto source = fieldSource(mesh_);
    const PreparedLinesPointer lines = prepareLines(mesh_, "sheet", source, say());
    const std::size_t points = linesOf(*lines).points.size();
    CMeshO other;
    makeSheet(other, 20);
    addDerivatives(*lines, other, "other", fieldSource(other), say());
    EXPECT_FALSE(lines->has_derivatives);
    EXPECT_NE(lines->lack, "");
    EXPECT_EQ(lines->failure, "");
    EXPECT_EQ(linesOf(*lines).points.size(), points);
    addDerivatives(*lines, mesh_, "sheet", source, say());
    EXPECT_TRUE(lines->has_derivatives);
    EXPECT_EQ(lines->lack, "");
}

}  // namespace
