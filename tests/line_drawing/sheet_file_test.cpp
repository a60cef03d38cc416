// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include <gtest/gtest.h>

#include <QXmlStreamReader>
#include <map>
#include <set>

#include "laplacian_lines/error.h"
#include "made_sheets.h"

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

TEST(SheetFiles, SvgIsInMillimetresWithLayers) {
    const std::string svg = writeSheet(smallSheet(), SheetFormat::Svg);
    for (const char* part :
         {"width=\"100mm\"", "height=\"50mm\"", "viewBox=\"0 0 100 50\"", "id=\"front-outline\"",
          "inkscape:groupmode=\"layer\"", "inkscape:label=\"Outlines\"",
          "d=\"M10 20l20 0c1 0 2 1 2 2\"", "stroke-width=\".25\"", "text-anchor=\"middle\"",
          "A &amp; B", "d=\"M40 10l5 0l0 5l-5 0l0-5z\""})
        EXPECT_TRUE(has(svg, part)) << part << "\n" << svg;
    QXmlStreamReader reader(QByteArray::fromStdString(svg));
    while (!reader.atEnd())
        reader.readNext();
    EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
}

TEST(SheetFiles, DashesAreAPropertyOfLines) {
    Sheet sheet = smallSheet();
    EXPECT_FALSE(has(writeSheet(sheet, SheetFormat::Svg), "dasharray"));
    EXPECT_FALSE(has(writeSheet(sheet, SheetFormat::Dxf), "DASHED"));
    sheet.groups[0].layers[0].paths[0].dash = 2;
    EXPECT_EQ(count(writeSheet(sheet, SheetFormat::Svg), "stroke-dasharray=\"2 1\""), 1);
    const std::string dxf = writeSheet(sheet, SheetFormat::Dxf);
    EXPECT_TRUE(has(dxf, "2\nDASHED\n"));
    EXPECT_TRUE(has(dxf, "2\nOUTLINE\n70\n0\n62\n7\n6\nDASHED\n"));
    EXPECT_TRUE(has(dxf, "2\nNAMES\n70\n0\n62\n30\n6\nCONTINUOUS\n"));
}

TEST(SheetFiles, DxfPointsUp) {
    const std::string dxf = writeSheet(smallSheet(), SheetFormat::Dxf);
    EXPECT_EQ(dxf.find("0\nSECTION\n"), 0u);
    EXPECT_TRUE(endsWith(dxf, "0\nEOF\n"));
    EXPECT_TRUE(has(dxf, "0\nVERTEX\n8\nOUTLINE\n10\n10.0000\n20\n30.0000\n"));
    EXPECT_TRUE(has(dxf, "1\n30%%d\n"));
}

/// Any text is one value of DXF; R12 has letters of four digits.
TEST(SheetFiles, OfDxfHaveTextsAsData) {
    Sheet sheet = smallSheet();
    SheetText& text = sheet.groups[0].layers[1].texts[0];
    const std::string before = writeSheet(sheet, SheetFormat::Dxf);
    text.text = "a\n0\nLINE\r8 100 %c 5%% %° \xc3\xbc \xf0\x9f\x98\x80";
    const std::string dxf = writeSheet(sheet, SheetFormat::Dxf);
    EXPECT_TRUE(has(dxf, "\n1\na 0 LINE 8 100 %c 5%%%%%% %%%%%d \\U+00FC ?\n"));
    EXPECT_EQ(count(dxf, "\n"), count(before, "\n"));
}

/// Colours of a file's layers by name.
std::map<std::string, int> layersOf(const std::string& dxf) {
    std::map<std::string, int> colors;
    const QList<QByteArray> lines = QByteArray::fromStdString(dxf).split('\n');
    for (int i = 0; i + 7 < lines.size(); i += 2)
        if (lines[i] == "0" && lines[i + 1] == "LAYER" && lines[i + 6] == "62")
            colors[lines[i + 3].toStdString()] = lines[i + 7].toInt();
    return colors;
}

TEST(SheetFiles, OfDxfHaveAColorForEachClass) {
    Sheet sheet = smallSheet();
    const SheetLayer lines = sheet.groups[0].layers[0];
    sheet.groups[0].layers.clear();
    for (const char* key : {"outline", "contour", "edge", "inner", "fine", "hidden", "section",
                            "marks", "area", "names", "scale", "title"})
        sheet.groups[0].layers.push_back({key, key, lines.paths, {}});
    sheet.groups[0].layers.push_back({"empty", "Empty", {}, {}});
    std::set<int> colors;
    for (const auto& [name, color] : layersOf(writeSheet(sheet, SheetFormat::Dxf)))
        EXPECT_TRUE(color > 0 && color < 256 && colors.insert(color).second) << name << color;
    EXPECT_EQ(colors.size(), 12u);
}

TEST(SheetFiles, OfDxfHaveLayersByViews) {
    SheetOptions options = made_sheets::plainViews("front,30,15,front");
    options.up = UpAxis::Z;
    options.sections = parseSections("y=0.5");
    const auto layers = layersOf(
        writeSheet(made_sheets::sheetOf(made_sheets::cubeOf100(), options), SheetFormat::Dxf));
    for (const char* name : {"FRONT_OUTLINE", "FRONT-2_OUTLINE", "VIEW-2_OUTLINE", "VIEW-4_SECTION",
                             "NAMES", "SCALE", "TITLE"})
        EXPECT_EQ(layers.count(name), 1u) << name;
    EXPECT_EQ(layers.count("OUTLINE"), 0u);
    EXPECT_EQ(layers.at("FRONT_OUTLINE"), layers.at("VIEW-2_OUTLINE"));
    for (const auto& [name, color] : layers)
        EXPECT_EQ(name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-"), name.npos)
            << name;
}

TEST(SheetFiles, OfDxfHavePlainStrokes) {
    EXPECT_EQ(strokesIn("plate.DXF", StrokeStyle::Tapered), StrokeStyle::Plain);
    EXPECT_EQ(strokesIn("dxf.svg", StrokeStyle::Tapered), StrokeStyle::Tapered);
}

TEST(SheetFiles, OfOtherKindsAreRefused) {
    for (const char* file : {"plate", "plate.jpg", "svg"})
        EXPECT_THROW(formatOf(file), laplacian_lines::Error) << file;
}

}  // namespace
