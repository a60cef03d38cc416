// SPDX-License-Identifier: GPL-3.0-or-later
// Paths and texts, and how files have them.
#include "line_drawing/sheet_file.h"

#include <gtest/gtest.h>

#include <random>

#include "formats/sheet_writers.h"
#include "laplacian_lines/error.h"
#include "sheet_helpers.h"

using namespace line_drawing;
using Eigen::Vector2d;
using sheet_helpers::has;
using sheet_helpers::painter_path;

namespace {

Vector2d point_at(double t, const Vector2d& begin, const Path::Piece& curve) {
    const double s = 1 - t;
    return s * s * s * begin + 3 * s * s * t * curve.first + 3 * s * t * t * curve.second +
           t * t * t * curve.end;
}

TEST(Paths, BoundsAndPointsAreThoseOfCurves) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-10, 10);
    const auto next = [&] { return Vector2d(place(random), place(random)); };
    constexpr double tolerance = 0.01;
    constexpr int steps = 2000;
    for (int round = 0; round < 200; ++round) {
        Path path;
        path.move_to(next());
        path.curve_to(next(), next(), next());
        const auto line = path.flattened(tolerance).at(0);
        Eigen::AlignedBox2d box;
        for (int i = 0; i <= steps; ++i) {
            const Vector2d p = point_at(i / double(steps), path.pieces[0].end, path.pieces[1]);
            box.extend(p);
            ASSERT_LT(sheet_helpers::distance_to(line, p), tolerance) << round;
        }
        EXPECT_LT((box.min() - path.bounds().min()).norm(), 1e-3) << round;
        EXPECT_LT((box.max() - path.bounds().max()).norm(), 1e-3) << round;
    }
}

TEST(Texts, AreReadAsUtf8WhateverTheyHold) {
    EXPECT_EQ(letters_of("a\xc3\xbc\xe2\x88\x9a\xf0\x9f\x98\x80"), U"a\u00fc\u221a\U0001f600");
    // cut off, too long, half of a pair, no beginning
    for (const char* wrong :
         {"\xc3", "\xe2\x88", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\x88"})
        EXPECT_EQ(letters_of(wrong), std::u32string(std::string(wrong).size(), U'\ufffd')) << wrong;
    EXPECT_EQ(in_utf8(letters_of("\xf0\x9f\x98\x80 \xc3\xa9")), "\xf0\x9f\x98\x80 \xc3\xa9");
    EXPECT_EQ(one_line("a\x7f\xc2\x85\xe2\x80\xa9"
                       "b"),
              "a   b");
}

TEST(Texts, AreNumbersOrNot) {
    for (const char* number : {"0.5", " .5 ", "+0.5", "5e-1"})
        EXPECT_EQ(number_in(number), 0.5) << number;
    for (const char* none : {"", " ", "+", "+-1", "1,5", "1 2", "0x1", "1e999"})
        EXPECT_FALSE(number_in(none)) << none;
    EXPECT_EQ(in_thousandths(-0.0496), "-.05");
    EXPECT_EQ(in_thousandths(0.0004), "0");
    EXPECT_EQ(in_thousandths(120), "120");
    EXPECT_EQ(in_digits(1e6), "1e+06");
}

std::string complaint_of(const std::string& title, const std::string& source, const char* file) {
    SheetOptions options;
    options.title = title;
    options.source = source;
    try {
        for (const std::string& remark : check_texts(options, file))
            return "remark: " + remark;
    } catch (const laplacian_lines::Error& error) {
        return error.what();
    }
    return {};
}

/// The outlines of a text of height 1, from (0, 0) on along its base line.
QPainterPath outlines_of(const char* text) {
    Sheet sheet{{10, 10}, "", {}};
    sheet.groups = {{"a", "A", {{"b", "B", {}, {{{0, 0}, 1, TextAnchor::Left, text}}}}}};
    outline_texts(sheet);
    const SheetLayer& layer = sheet.groups[0].layers[0];
    EXPECT_TRUE(layer.texts.empty());
    return layer.paths.empty() ? QPainterPath() : painter_path(layer.paths[0].path);
}

TEST(Lettering, HasTheFormsOfLetters) {
    const QPainterPath l = outlines_of("l"), o = outlines_of("o");
    EXPECT_NEAR(l.boundingRect().height(), 0.725, 0.01);
    EXPECT_NEAR(l.boundingRect().bottom(), 0, 1e-9);
    EXPECT_TRUE(l.contains(l.boundingRect().center()));
    EXPECT_FALSE(o.contains(o.boundingRect().center()));
    EXPECT_TRUE(o.contains({o.boundingRect().left() + 0.03, o.boundingRect().center().y()}));
    EXPECT_LT(o.boundingRect().height(), 0.6);
}

/// Also an accent that follows its letter, and the letter after it stands as without.
TEST(Lettering, PutsAccentsOnLetters) {
    const double right = outlines_of("el").boundingRect().right();
    for (const char* text : {"\xc3\xa9", "e\xcc\x81"}) {  // U+00E9; e and U+0301
        const QRectF box = outlines_of(text).boundingRect();
        EXPECT_LT(box.top(), -0.7) << text;
        EXPECT_GT(box.left(), 0) << text;
        EXPECT_NEAR(outlines_of((text + std::string("l")).c_str()).boundingRect().right(), right,
                    1e-9);
    }
}

TEST(Lettering, HasOtherSignsForLettersThatItLacks) {
    EXPECT_EQ(outlines_of("\xe6\x97\xa5"), outlines_of("\xe2\x96\xa1"));  // a box
    EXPECT_EQ(outlines_of("⌀"), outlines_of("Ø"));
    EXPECT_EQ(outlines_of("\xff"), outlines_of("?"));
    for (const char* sign : {"\xe2\x96\xa1", "Ø", "?"})
        EXPECT_FALSE(outlines_of(sign).isEmpty()) << sign;
    EXPECT_TRUE(outlines_of(" ").isEmpty());
}

TEST(Lettering, RefusesTitlesWithLettersThatItLacks) {
    const std::string han = "\xe6\x97\xa5", lodz = "\xc5\x81\xc3\xb3\x64\xc5\xba";
    for (const char* file : {".pdf", ".png"}) {
        EXPECT_EQ(complaint_of(lodz + " \xd0\x96 \xce\xa9 \xef\xbf\xbd\n", lodz + ".ply", file),
                  "");
        const std::string of_title = complaint_of(han, "", file),
                          of_source = complaint_of("", han, file);
        for (const std::string& said : {of_title, of_source}) {
            EXPECT_NE(said.find("\"" + han + "\""), said.npos) << said;
            EXPECT_NE(said.find("SVG"), said.npos) << said;
        }
        EXPECT_NE(of_title.find("remark: "), 0u);
        EXPECT_EQ(of_source.find("remark: "), 0u);
    }
    EXPECT_EQ(complaint_of(han, han, ".svg") + complaint_of(han, han, ".dxf"), "");
}

Sheet small_sheet() {
    Sheet sheet{{100, 50}, "A & B", {}};
    SheetPath line{{}, 0.25};
    line.path.move_to({10, 20});
    line.path.line_to({30.0004, 20});
    line.path.curve_to({31, 20}, {32, 21}, {32, 22});
    SheetPath area;
    area.path.add_rectangle({40, 10}, 5, 5);
    sheet.groups.push_back({"front",
                            "Front",
                            {{"outline", "Outlines", {line, area}, {}},
                             {"names", "Names", {}, {{{50, 40}, 3, TextAnchor::Middle, "30°"}}}}});
    return sheet;
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

TEST(SheetFiles, DashesAreAPropertyOfLines) {
    Sheet sheet = small_sheet();
    EXPECT_FALSE(has(write_sheet(sheet, ".svg"), "dasharray"));
    EXPECT_FALSE(has(write_sheet(sheet, ".dxf"), "DASHED"));
    sheet.groups[0].layers[0].paths[0].dash = 2;
    EXPECT_EQ(count(write_sheet(sheet, ".svg"), "stroke-dasharray=\"2 1\""), 1);
    const std::string dxf = write_sheet(sheet, ".dxf");
    EXPECT_TRUE(has(dxf, "2\nDASHED\n"));
    EXPECT_TRUE(has(dxf, "2\nOUTLINE\n70\n0\n62\n7\n6\nDASHED\n"));
    EXPECT_TRUE(has(dxf, "2\nNAMES\n70\n0\n62\n30\n6\nCONTINUOUS\n"));
}

/// Any text is one value of DXF; R12 has letters of four digits.
TEST(SheetFiles, OfDxfHaveTextsAsData) {
    Sheet sheet = small_sheet();
    SheetText& text = sheet.groups[0].layers[1].texts[0];
    const std::string before = write_sheet(sheet, ".dxf");
    text.text = "a\n0\nLINE\r8 100 %c 5%% %° x^3 \xc3\xbc \xf0\x9f\x98\x80";
    const std::string dxf = write_sheet(sheet, ".dxf");
    EXPECT_TRUE(has(dxf, "\n1\na 0 LINE 8 100 %c 5%%%%%% %%%%%d x^ 3 \\U+00FC ?\n"));
    EXPECT_EQ(count(dxf, "\n"), count(before, "\n"));
}

TEST(SheetFiles, OfPdfHaveLargerUnitsAboveFiveMetres) {
    const std::string pdf = write_sheet({{100, 12700}, "", {}}, ".pdf");  // 36,000 points high
    EXPECT_TRUE(has(pdf, "[0 0 94.48818898 12000] /UserUnit 3 "));
    EXPECT_TRUE(has(pdf, deflated("0.9448818898 0 0 -0.9448818898 0 12000 cm 1 J 1 j\n")));
}

}  // namespace
