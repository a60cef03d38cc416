// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/make_sheet.h"

#include <gtest/gtest.h>

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

}  // namespace
