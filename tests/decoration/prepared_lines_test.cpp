// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared_lines.h"

#include <gtest/gtest.h>

#include "laplacian_lines/line_mixture.h"
#include "wavy_sheet.h"

namespace {

using meshlab_host::field_source;
using meshlab_host::with_derivatives;

class PreparedLinesTest : public testing::Test {
protected:
    PreparedLinesTest() { make_sheet(mesh_, 30); }

    laplacian_lines::LineSet lines_of(const PreparedLines& prepared) {
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
    const auto source = field_source(mesh_);
    const PreparedLinesPointer lines = prepare_lines(mesh_, "sheet", source, say());
    const PreparedLinesPointer whole =
        prepare_lines(mesh_, "sheet", with_derivatives(source), say());
    EXPECT_FALSE(lines->has_derivatives);
    EXPECT_TRUE(whole->has_derivatives);
    EXPECT_FALSE(lines->key < whole->key || whole->key < lines->key) << "they are found alike";
    EXPECT_NE(lines_of(*lines).points.size(), lines_of(*whole).points.size());

    const auto surface = lines->surface;
    EXPECT_EQ(said_.filter("default options").size(), 2) << "each preparation says so";
    said_.clear();
    add_derivatives(*lines, mesh_, "sheet", source, say());
    EXPECT_TRUE(lines->has_derivatives);
    EXPECT_EQ(lines->missing_reason, "");
    EXPECT_EQ(lines->surface, surface);
    EXPECT_EQ(lines_of(*lines).points.size(), lines_of(*whole).points.size());
    EXPECT_EQ(lines->bytes, whole->bytes) << "the field is not kept any longer";
    EXPECT_EQ(said_.filter("default options").size(), 0);
    EXPECT_EQ(said_.filter("also need").size(), 1);
}

/// Adding them fails here because the mesh has another number of vertices than the field.
TEST_F(PreparedLinesTest, StayAsTheyAreWithoutDerivatives) {
    const auto source = field_source(mesh_);
    const PreparedLinesPointer lines = prepare_lines(mesh_, "sheet", source, say());
    const std::size_t points = lines_of(*lines).points.size();
    CMeshO other;
    make_sheet(other, 20);
    add_derivatives(*lines, other, "other", field_source(other), say());
    EXPECT_FALSE(lines->has_derivatives);
    EXPECT_NE(lines->missing_reason, "");
    EXPECT_EQ(lines->failure, "");
    EXPECT_EQ(lines_of(*lines).points.size(), points);
    said_.clear();
    add_derivatives(*lines, mesh_, "sheet", source, say());
    EXPECT_EQ(said_.filter("default options").size(), 0) << "the field is still there";
    EXPECT_TRUE(lines->has_derivatives);
    EXPECT_EQ(lines->missing_reason, "");
}

}  // namespace
