// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "laplacian_lines/error.h"
#include "line_drawing/sheet_file.h"
#include "made_sheets.h"

using namespace line_drawing;
using made_sheets::painterPath;

namespace {

std::string complaintOf(const std::string& title, const std::string& source, const char* file) {
    SheetOptions options;
    options.title = title;
    options.source = source;
    try {
        for (const std::string& remark : checkTexts(options, file))
            return "remark: " + remark;
    } catch (const laplacian_lines::Error& error) {
        return error.what();
    }
    return {};
}

/// The outlines of a text of height 1, from (0, 0) on along its base line.
QPainterPath outlinesOf(const char* text) {
    Sheet sheet{{10, 10}, "", {}};
    sheet.groups = {{"a", "A", {{"b", "B", {}, {{{0, 0}, 1, TextAnchor::Left, text}}}}}};
    outlineTexts(sheet);
    const SheetLayer& layer = sheet.groups[0].layers[0];
    EXPECT_TRUE(layer.texts.empty());
    return layer.paths.empty() ? QPainterPath() : painterPath(layer.paths[0].path);
}

TEST(Lettering, HasTheFormsOfLetters) {
    const QPainterPath l = outlinesOf("l"), o = outlinesOf("o");
    EXPECT_NEAR(l.boundingRect().height(), 0.725, 0.01);
    EXPECT_NEAR(l.boundingRect().bottom(), 0, 1e-9);
    EXPECT_TRUE(l.contains(l.boundingRect().center()));
    EXPECT_FALSE(o.contains(o.boundingRect().center()));
    EXPECT_TRUE(o.contains({o.boundingRect().left() + 0.03, o.boundingRect().center().y()}));
    EXPECT_LT(o.boundingRect().height(), 0.6);
}

/// Also an accent that follows its letter, and the letter after it stands as without.
TEST(Lettering, PutsAccentsOnLetters) {
    const double right = outlinesOf("el").boundingRect().right();
    for (const char* text : {"\xc3\xa9", "e\xcc\x81"}) {  // U+00E9; e and U+0301
        const QRectF box = outlinesOf(text).boundingRect();
        EXPECT_LT(box.top(), -0.7) << text;
        EXPECT_GT(box.left(), 0) << text;
        EXPECT_NEAR(outlinesOf((text + std::string("l")).c_str()).boundingRect().right(), right,
                    1e-9);
    }
}

TEST(Lettering, HasOtherSignsForLettersThatItLacks) {
    EXPECT_EQ(outlinesOf("\xe6\x97\xa5"), outlinesOf("\xe2\x96\xa1"));  // a box
    EXPECT_EQ(outlinesOf("⌀"), outlinesOf("Ø"));
    EXPECT_EQ(outlinesOf("\xff"), outlinesOf("?"));
    EXPECT_TRUE(outlinesOf(" ").isEmpty());
}

TEST(Lettering, RefusesTitlesWithLettersThatItLacks) {
    const std::string han = "\xe6\x97\xa5", lodz = "\xc5\x81\xc3\xb3\x64\xc5\xba";
    for (const char* file : {".pdf", ".png"}) {
        EXPECT_EQ(complaintOf(lodz + " \xd0\x96 \xce\xa9 \xef\xbf\xbd\n", lodz + ".ply", file), "");
        const std::string of_title = complaintOf(han, "", file),
                          of_source = complaintOf("", han, file);
        for (const std::string& said : {of_title, of_source}) {
            EXPECT_NE(said.find("\"" + han + "\""), said.npos) << said;
            EXPECT_NE(said.find("SVG"), said.npos) << said;
        }
        EXPECT_NE(of_title.find("remark: "), 0u);
        EXPECT_EQ(of_source.find("remark: "), 0u);
    }
    EXPECT_EQ(complaintOf(han, han, ".svg") + complaintOf(han, han, ".dxf"), "");
}

}  // namespace
