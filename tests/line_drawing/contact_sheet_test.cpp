// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/make_sheet.h"

#include <gtest/gtest.h>

#include <QImage>

#include "formats/sheet_writers.h"
#include "laplacian_lines/error.h"
#include "made_sheets.h"

using namespace line_drawing;

namespace {

ContactEntry entryOf(const laplacian_lines::TriangleMesh& mesh, const char* name) {
    SheetOptions options;
    options.views = parseViews("front,left", UpAxis::Z);
    return {name, made_sheets::sheetOf(mesh, contactOptions(mesh, options))};
}

std::vector<ContactEntry> cubes(int count) {
    return std::vector<ContactEntry>(std::size_t(count),
                                     entryOf(made_sheets::cubeOf100(), "a cube"));
}

TEST(ContactSheets, HoldAllViewsWithoutOverlapOnOnePage) {
    for (const int count : {1, 2, 6, 13, 40, 200}) {
        const Sheet sheet = makeContactSheet(cubes(count), "Cubes");
        ASSERT_EQ(sheet.groups.size(), std::size_t(count) + 1);
        const QRectF page = made_sheets::paperOf(sheet.size);
        for (int i = 0; i < count; ++i) {
            const QRectF place = made_sheets::extentOf(sheet.groups[std::size_t(i)]);
            EXPECT_GT(place.width(), 30) << count;
            EXPECT_NEAR(place.width(), place.height(), 0.2);
            EXPECT_TRUE(page.contains(place));
            EXPECT_EQ(sheet.groups[std::size_t(i)].layers.back().texts[0].text, "a cube");
            for (int k = 0; k < i; ++k)
                EXPECT_FALSE(place.intersects(made_sheets::extentOf(sheet.groups[std::size_t(k)])));
        }
    }
    EXPECT_TRUE(makeContactSheet({}, "").groups.empty());
}

TEST(ContactSheets, TellSizes) {
    const ContactEntry entry = entryOf(made_sheets::cubeOf100(), "cube");
    EXPECT_EQ(entry.view.groups.size(), 1u);  // one view, no furniture
    EXPECT_EQ(makeContactSheet({entry}, "").groups[0].layers.back().texts[1].text,
              "100.0 × 100.0 × 100.0 mm");
}

TEST(ContactSheets, ArePackedAndUnpacked) {
    const Sheet view = entryOf(test_meshes::bumpy_sphere(3).mesh, "").view;
    const std::string bytes = packSheet(view);
    const Sheet same = unpackSheet(bytes);
    EXPECT_EQ(writeSvg(same), writeSvg(view));
    Sheet dashed = view;
    dashed.scale = 0.25;
    dashed.groups.at(0).layers.at(0).paths = {{{}, 0.5, 2, 0.75}};
    const Sheet unpacked = unpackSheet(packSheet(dashed));
    EXPECT_EQ(unpacked.scale, 0.25);
    EXPECT_EQ(unpacked.groups.at(0).layers.at(0).paths.at(0).dash, 2);
    EXPECT_EQ(unpacked.groups.at(0).layers.at(0).paths.at(0).tone, 0.75);
    EXPECT_THROW(unpackSheet("no sheet"), laplacian_lines::Error);
    EXPECT_THROW(unpackSheet({}), laplacian_lines::Error);
    for (const std::size_t size :
         {std::size_t(6), std::size_t(40), bytes.size() / 2, bytes.size() - 1})
        EXPECT_THROW(unpackSheet(bytes.substr(0, size)), laplacian_lines::Error) << size;
}

TEST(MeasuredDrawing, OfSeveralSheetsIsThatOfEach) {
    const auto mesh = test_meshes::bumpy_sphere(3).mesh;
    const auto field = laplacian_lines::precompute(mesh);
    SheetOptions a, b;
    a.views = parseViews("front", UpAxis::Y);
    b.views = parseViews("left,top", UpAxis::Y);
    double last = 0;
    const auto sheets = makeSheets({{mesh, &field}}, {a, b}, [&](double done, const char*) {
        EXPECT_GE(done, last);
        last = done;
        return true;
    });
    EXPECT_EQ(last, 1);
    ASSERT_EQ(sheets.size(), 2u);
    EXPECT_EQ(writeSvg(sheets[0]), writeSvg(makeSheet(mesh, field, a)));
    EXPECT_EQ(writeSvg(sheets[1]), writeSvg(makeSheet(mesh, field, b)));
}

TEST(SheetFiles, PngHasItsDotsPerInch) {
    Sheet sheet{{127, 50.8}, "", {}, 1};
    SheetPath area;
    area.path.addRectangle({25.4, 25.4}, 50.8, 12.7);
    sheet.groups.push_back({"a", "A", {{"outline", "Outlines", {area}, {}}}});
    const QImage image = QImage::fromData(QByteArray::fromStdString(writePng(sheet, 100)));
    EXPECT_EQ(image.size(), QSize(500, 200));
    EXPECT_NEAR(image.dotsPerMeterX() * 0.0254, 100, 0.05);
    int black = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            black += qGray(image.pixel(x, y)) < 128;
    EXPECT_EQ(black, 200 * 50);
    EXPECT_LT(qGray(image.pixel(101, 101)), 128);
    EXPECT_GT(qGray(image.pixel(99, 101)), 128);
    EXPECT_THROW(writePng(sheet, 1e5), laplacian_lines::Error);
}

}  // namespace
