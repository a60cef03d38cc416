// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_layout.h"

#include <gtest/gtest.h>

#include "laplacian_lines/error.h"
#include "made_sheets.h"

using namespace line_drawing;

namespace {

/// Of an upright box of 60 x 40 x 20 (x, y, z).
std::vector<DrawnView> viewsOfABox(const char* names) {
    std::vector<DrawnView> views;
    for (const ViewFrame& frame : parseViews(names, UpAxis::Z)) {
        const Eigen::Vector3d half(30, 20, 10);
        const Eigen::Vector2d size(frame.right.cwiseAbs().dot(half), frame.up.cwiseAbs().dot(half));
        views.push_back({frame, {-size, size}, {}});
    }
    return views;
}

TEST(SheetLayout, KnowsThePapersThatItNames) {
    SheetOptions options;
    for (const char* name : paperNames()) {
        options.paper = upper(name);
        EXPECT_GT(layOut(viewsOfABox("front"), options).size.x(), 100) << name;
    }
    EXPECT_EQ(paperNames().size(), 6u);
}

TEST(SheetLayout, AlignsTheViewsInFirstAngle) {
    const SheetLayout layout = layOut(viewsOfABox("six"), {});
    const auto& at = layout.placements;  // front, back, left, right, top, bottom
    const Eigen::Vector2d front = at[0].middle;
    for (const int beside : {1, 2, 3})
        EXPECT_EQ(at[std::size_t(beside)].middle.y(), front.y());
    EXPECT_EQ(at[4].middle.x(), front.x());
    EXPECT_EQ(at[5].middle.x(), front.x());
    EXPECT_GT(at[2].middle.x(), front.x());  // from the left on the right
    EXPECT_LT(at[3].middle.x(), front.x());
    EXPECT_GT(at[4].middle.y(), front.y());  // from above below
    EXPECT_LT(at[5].middle.y(), front.y());
}

TEST(SheetLayout, TurnsTheArrangementInThirdAngle) {
    SheetOptions options;
    options.arrangement = Arrangement::ThirdAngle;
    const SheetLayout layout = layOut(viewsOfABox("front,left,top,back"), options);
    const Eigen::Vector2d front = layout.placements[0].middle;
    EXPECT_LT(layout.placements[1].middle.x(), front.x());
    EXPECT_LT(layout.placements[2].middle.y(), front.y());
    EXPECT_GT(layout.placements[3].middle.x(), front.x());
}

TEST(SheetLayout, ViewsDoNotOverlapAndStayOnThePaper) {
    for (const char* names : {"front", "six", "six 30,15 60,15 90,40 0,10 45,45", "top,bottom"}) {
        const SheetLayout layout = layOut(viewsOfABox(names), {});
        const QRectF paper = made_sheets::paperOf(layout.size);
        for (std::size_t i = 0; i < layout.places.size(); ++i) {
            EXPECT_TRUE(paper.contains(made_sheets::inQt(layout.places[i]))) << names;
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_TRUE(layout.places[i].intersection(layout.places[k]).isEmpty()) << names;
        }
    }
}

/// Thirty in one row would not fit at any scale.
TEST(SheetLayout, ManySectionsStandInRows) {
    for (const char* names : {"", "front,top"}) {
        std::vector<DrawnView> views;
        if (*names) views = viewsOfABox(names);
        SheetOptions options;
        options.sections.resize(30);
        const Eigen::Vector2d half(20, 10);
        for (const Section& section : options.sections) {
            views.push_back({frameOfSection(section, UpAxis::Z), {-half, half}, {}});
            views.back().is_section = true;
        }
        const SheetLayout layout = layOut(views, options);
        EXPECT_GE(layout.scale, 0.5);
        for (std::size_t i = 0; i < layout.places.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_TRUE(layout.places[i].intersection(layout.places[k]).isEmpty()) << names;
    }
}

TEST(SheetLayout, TakesTheLargestUsualScaleThatFits) {
    SheetOptions options;
    EXPECT_EQ(layOut(viewsOfABox("front"), options).scale, 4);  // 240 mm on lying A4
    options.paper = "a5";
    EXPECT_EQ(layOut(viewsOfABox("front"), options).scale, 2);
}

TEST(SheetLayout, PaperCanBeAsLargeAsTheDrawing) {
    SheetOptions options;
    options.paper = "fit";
    options.scale = 10;
    const SheetLayout layout = layOut(viewsOfABox("front"), options);
    EXPECT_EQ(layout.places[0].sizes().x(), 600);
    EXPECT_EQ(layout.size.x(), 600 + 2 * sheet_margin);
}

TEST(SheetLayout, SaysWhichScaleWouldFit) {
    SheetOptions options;
    options.scale = 10;
    try {
        layOut(viewsOfABox("front"), options);
        FAIL();
    } catch (const laplacian_lines::Error& error) {
        EXPECT_NE(std::string(error.what()).find("Take the scale 4:1"), std::string::npos)
            << error.what();
    }
    options.paper = "letter";
    EXPECT_THROW(layOut(viewsOfABox("front"), options), laplacian_lines::Error);
}

TEST(SheetLayout, ScalesHaveNames) {
    EXPECT_EQ(parseScale("1:2"), 0.5);
    EXPECT_EQ(parseScale("5:2"), 2.5);
    EXPECT_EQ(parseScale("fit"), 0);
    EXPECT_EQ(scaleInWords(0.5), "1:2");
    EXPECT_EQ(scaleInWords(1), "1:1");
    EXPECT_EQ(scaleInWords(20), "20:1");
    for (const char* word :
         {"", "2", "1:0", "-1:2", "1:2:3", "a:b", "nan:1", "1:inf", "1:1e308", "1e308:1"})
        EXPECT_THROW(parseScale(word), laplacian_lines::Error) << word;
}

TEST(SheetFurniture, ScaleBarsAreOfRoundLengths) {
    EXPECT_EQ(barLength(1, 50), 50);
    EXPECT_EQ(barLength(0.5, 50), 100);
    EXPECT_EQ(barLength(1. / 3, 50), 100);
    EXPECT_EQ(barLength(4, 50), 10);
    EXPECT_EQ(lengthInWords(100), "10 cm");
    EXPECT_EQ(lengthInWords(2000), "2 m");
    EXPECT_EQ(lengthInWords(0.5), "0.5 mm");
}

TEST(SheetFurniture, LongTitlesAreWhole) {
    SheetOptions options = made_sheets::plainViews("front", "a4");
    for (int i = 0; i < 30; ++i)
        options.title += (i ? " word" : "word") + std::to_string(i);
    const auto title_of = [&] {
        const Sheet sheet = made_sheets::sheetOf(test_meshes::torus(30, 15).mesh, options);
        EXPECT_EQ(sheet.remarks.size(), 1u);
        Words lines;
        for (const SheetText& text : made_sheets::layerOf(sheet.groups.back(), "title").texts)
            if (text.text.find("word") != text.text.npos) lines.insert(lines.begin(), text.text);
        return joined(lines, " ");
    };
    EXPECT_EQ(title_of(), options.title);
    options.title += options.title + options.title + options.title;
    EXPECT_TRUE(endsWith(title_of(), "…"));
}

TEST(SheetPlans, AreWhatIsMade) {
    const auto mesh = test_meshes::torus(30, 15).mesh;
    for (const char* views : {"front", "six", "30,15 top"})
        for (const char* paper : {"a4", "a2", "fit"})
            for (const double scale : {0., 10.})
                for (const char* sections : {"", "y=0.4 z=0.5"}) {
                    SheetOptions options = made_sheets::plainViews(views, paper);
                    options.scale = scale;
                    options.sections = parseSections(sections);
                    const Sheet sheet = made_sheets::sheetOf(mesh, options);
                    const SheetPlan plan = planSheet({{mesh}}, options);
                    EXPECT_EQ(plan.scale, sheet.scale) << views << paper << scale << sections;
                    EXPECT_EQ(plan.paper, sheet.size) << views << paper << scale << sections;
                }
}

TEST(SheetPlans, RefuseWhatIsRefused) {
    const laplacian_lines::TriangleMesh mesh = made_sheets::cubeOf100(), empty;
    SheetOptions options = made_sheets::plainViews("front", "a5");
    options.scale = 10;
    EXPECT_THROW(planSheet({{mesh}}, options), laplacian_lines::Error);
    EXPECT_THROW(planSheet({{empty}}, options), laplacian_lines::Error);
    options.views.clear();
    EXPECT_THROW(planSheet({{mesh}}, options), laplacian_lines::Error);
}

}  // namespace
