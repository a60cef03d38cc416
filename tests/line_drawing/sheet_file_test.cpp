// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include <gtest/gtest.h>

#include "line_drawing/words.h"

using namespace line_drawing;

namespace {

Sheet smallSheet() {
    Sheet sheet{{100, 50}, "A & B", {}};
    SheetPath line{{}, 0.25};
    line.path.moveTo({10, 20});
    line.path.lineTo({30.0004, 20});
    line.path.curveTo({31, 20}, {32, 21}, {32, 22});
    SheetPath area;
    area.path.addRectangle({40, 10}, 5, 5);
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

bool has(const std::string& text, const std::string& part) {
    return count(text, part) > 0;
}

TEST(SheetFiles, DashesAreAPropertyOfLines) {
    Sheet sheet = smallSheet();
    EXPECT_FALSE(has(writeSheet(sheet, ".svg"), "dasharray"));
    EXPECT_FALSE(has(writeSheet(sheet, ".dxf"), "DASHED"));
    sheet.groups[0].layers[0].paths[0].dash = 2;
    EXPECT_EQ(count(writeSheet(sheet, ".svg"), "stroke-dasharray=\"2 1\""), 1);
    const std::string dxf = writeSheet(sheet, ".dxf");
    EXPECT_TRUE(has(dxf, "2\nDASHED\n"));
    EXPECT_TRUE(has(dxf, "2\nOUTLINE\n70\n0\n62\n7\n6\nDASHED\n"));
    EXPECT_TRUE(has(dxf, "2\nNAMES\n70\n0\n62\n30\n6\nCONTINUOUS\n"));
}

/// Any text is one value of DXF; R12 has letters of four digits.
TEST(SheetFiles, OfDxfHaveTextsAsData) {
    Sheet sheet = smallSheet();
    SheetText& text = sheet.groups[0].layers[1].texts[0];
    const std::string before = writeSheet(sheet, ".dxf");
    text.text = "a\n0\nLINE\r8 100 %c 5%% %° \xc3\xbc \xf0\x9f\x98\x80";
    const std::string dxf = writeSheet(sheet, ".dxf");
    EXPECT_TRUE(has(dxf, "\n1\na 0 LINE 8 100 %c 5%%%%%% %%%%%d \\U+00FC ?\n"));
    EXPECT_EQ(count(dxf, "\n"), count(before, "\n"));
}

}  // namespace
