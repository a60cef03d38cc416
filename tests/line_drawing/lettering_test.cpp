// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/lettering.h"

#include <gtest/gtest.h>

#include "formats/pdf_parts.h"
#include "laplacian_lines/error.h"
#include "line_drawing/sheet_file.h"
#include "line_drawing/words.h"
#include "painter_path.h"

using namespace line_drawing;

namespace {

std::string complaintOf(const std::string& title, const std::string& source, SheetFormat format) {
    SheetOptions options;
    options.title = title;
    options.source = source;
    try {
        for (const std::string& remark : checkTexts(options, format))
            return "remark: " + remark;
    } catch (const laplacian_lines::Error& error) {
        return error.what();
    }
    return {};
}

TEST(Lettering, IsAsWideAsThatOfPdf) {
    for (char32_t letter = 32; letter < 0x2300; ++letter) {
        const std::string text = inUtf8({&letter, 1});
        const StandardText standard = inStandardFonts(text);
        if (!standard.is_whole || letter == U'\u221a' || letter == U'\u00af') continue;
        EXPECT_NEAR(letteringOf(text).width, standard.width, 0.06) << text;
    }
    EXPECT_DOUBLE_EQ(letteringOf("").width, 0);
    EXPECT_TRUE(letteringOf(" ").path.isEmpty());
}

TEST(Lettering, HasTheFormsOfLetters) {
    const QPainterPath l = painterPath(letteringOf("l").path),
                       o = painterPath(letteringOf("o").path);
    EXPECT_NEAR(l.boundingRect().height(), 0.725, 0.01);
    EXPECT_NEAR(l.boundingRect().bottom(), 0, 1e-9);
    EXPECT_TRUE(l.contains(l.boundingRect().center()));
    EXPECT_FALSE(o.contains(o.boundingRect().center()));
    EXPECT_TRUE(o.contains({o.boundingRect().left() + 0.03, o.boundingRect().center().y()}));
    EXPECT_LT(o.boundingRect().height(), 0.6);
}

/// Also an accent that follows its letter.
TEST(Lettering, PutsAccentsOnLetters) {
    for (const char* text : {"\xc3\xa9", "e\xcc\x81"}) {  // U+00E9; e and U+0301
        const Lettering letters = letteringOf(text);
        const QRectF box = painterPath(letters.path).boundingRect();
        EXPECT_NEAR(letters.width, letteringOf("e").width, 1e-9);
        EXPECT_LT(box.top(), -0.7) << text;
        EXPECT_GT(box.left(), 0) << text;
        EXPECT_LT(box.right(), letters.width) << text;
    }
}

TEST(Lettering, HasBoxesForLettersThatItLacks) {
    const Lettering box = letteringOf("\xe2\x96\xa1"), han = letteringOf("\xe6\x97\xa5");
    EXPECT_DOUBLE_EQ(han.width, box.width);
    EXPECT_EQ(painterPath(han.path), painterPath(box.path));
}

TEST(Lettering, DrawsLettersThatLookAlike) {
    EXPECT_EQ(painterPath(letteringOf("⌀").path), painterPath(letteringOf("Ø").path));
    EXPECT_EQ(lackingLetter("⌀ 5"), "");
}

TEST(Lettering, RefusesTitlesWithLettersThatItLacks) {
    const std::string han = "\xe6\x97\xa5", lodz = "\xc5\x81\xc3\xb3\x64\xc5\xba";
    for (const SheetFormat format : {SheetFormat::Pdf, SheetFormat::Png}) {
        EXPECT_EQ(complaintOf(lodz + " \xd0\x96 \xce\xa9 \xef\xbf\xbd\n", lodz + ".ply", format),
                  "");
        const std::string of_title = complaintOf(han, "", format),
                          of_source = complaintOf("", han, format);
        for (const std::string& said : {of_title, of_source}) {
            EXPECT_NE(said.find("\"" + han + "\""), said.npos) << said;
            EXPECT_NE(said.find("SVG"), said.npos) << said;
        }
        EXPECT_NE(of_title.find("remark: "), 0u);
        EXPECT_EQ(of_source.find("remark: "), 0u);
    }
    EXPECT_EQ(complaintOf(han, han, SheetFormat::Svg) + complaintOf(han, han, SheetFormat::Dxf),
              "");
}

}  // namespace
