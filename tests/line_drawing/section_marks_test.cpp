// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections/section_marks.h"

#include <gtest/gtest.h>

#include "made_sheets.h"

using namespace line_drawing;
using Eigen::Vector2d;
using made_sheets::painterPath;

namespace {

SheetOptions withSections(const char* views, const char* sections) {
    SheetOptions options = made_sheets::plainViews(views);
    options.sections = parseSections(sections);
    options.up = UpAxis::Z;
    return options;
}

const SheetLayer* marksOf(const SheetGroup& group) {
    for (const SheetLayer& layer : group.layers)
        if (layer.key == "marks") return &layer;
    return nullptr;
}

TEST(SectionMarks, StandWhereThePlaneIsAndPointAlongTheSight) {
    const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(10, 20, 40));
    const SheetOptions options = withSections("front", "x=0.25 z=0.75 y=0.5");
    const auto marks = line_drawing::marksOf(options.views[0], options, box);
    ASSERT_EQ(marks.size(), 2u);  // the front view looks through y
    EXPECT_EQ(marks[0].letter, "A");
    EXPECT_EQ(marks[0].point, Vector2d(-2.5, 0));
    EXPECT_EQ(marks[0].along.cwiseAbs(), Vector2d(0, 1));
    EXPECT_EQ(marks[0].looking, Vector2d(1, 0));  // a section across x is seen from the left
    EXPECT_EQ(marks[1].letter, "B");
    EXPECT_EQ(marks[1].point, Vector2d(0, 10));
    EXPECT_EQ(marks[1].looking, Vector2d(0, -1));  // from above
}

TEST(SectionMarks, StayBesideTheSurfaceAndOnThePaper) {
    SheetOptions options = withSections("front,left,top", "x=0.3 y=0.5 z=0.6");
    options.paper = "fit";
    const Sheet sheet = made_sheets::sheetOf(made_sheets::cubeOf100(), options);
    const QRectF paper = made_sheets::paperOf(sheet.size);
    for (std::size_t view = 0; view < 3; ++view) {
        const SheetLayer* marks = marksOf(sheet.groups[view]);
        ASSERT_TRUE(marks);
        EXPECT_EQ(marks->texts.size(), 4u);
        EXPECT_EQ(marks->paths.size(), 12u);
        SheetGroup lines = sheet.groups[view];
        lines.layers.pop_back();
        const QRectF surface = made_sheets::extentOf(lines);
        EXPECT_NEAR(surface.width(), 100, 0.1);
        for (const SheetPath& path : marks->paths) {
            const QRectF mark =
                painterPath(path.path).boundingRect().adjusted(-0.25, -0.25, 0.25, 0.25);
            EXPECT_FALSE(mark.intersects(surface));
            EXPECT_TRUE(paper.contains(mark));
        }
        for (const SheetText& text : marks->texts) {
            EXPECT_FALSE(surface.contains(text.position.x(), text.position.y()));
            EXPECT_TRUE(paper.contains(text.position.x(), text.position.y()));
        }
    }
}

TEST(SectionMarks, GiveSectionsTheirNames) {
    const auto mesh = made_sheets::cubeOf100();
    const Sheet marked = made_sheets::sheetOf(mesh, withSections("front", "x=0.3 z=0.6"));
    EXPECT_EQ(marked.groups[1].name, "A–A");
    EXPECT_EQ(marked.groups[2].name, "B–B");
    SheetOptions alone = withSections("front", "x=0.3");
    alone.views.clear();
    EXPECT_EQ(made_sheets::sheetOf(mesh, alone).groups[0].name, "Section x = 30 %");
    EXPECT_EQ(letterOf(25), "Z");
    EXPECT_EQ(letterOf(26), "AA");
    EXPECT_EQ(letterOf(53), "BB");
}

TEST(SectionMarks, SectionsStandInLineWithTheFront) {
    const Sheet sheet = made_sheets::sheetOf(made_sheets::cubeOf100(),
                                             withSections("front,left", "x=0.3 y=0.4 z=0.6"));
    std::vector<QRectF> places;
    for (std::size_t view = 0; view < 5; ++view) {
        SheetGroup lines = sheet.groups[view];
        if (marksOf(lines)) lines.layers.pop_back();
        places.push_back(made_sheets::extentOf(lines));
    }
    EXPECT_NEAR(places[2].top(), places[0].top(), 0.05);
    EXPECT_NEAR(places[3].top(), places[0].top(), 0.05);
    EXPECT_GT(places[2].left(), places[1].right());
    EXPECT_GT(places[3].left(), places[2].right());
    EXPECT_NEAR(places[4].left(), places[0].left(), 0.05);
    EXPECT_GT(places[4].top(), places[0].bottom());
}

TEST(Walls, AreHatchedFilledOrEmpty) {
    const auto mesh = made_sheets::cubeOf100();
    const auto areaOf = [&](WallStyle wall, std::size_t& hatching) {
        SheetOptions options = withSections("front", "x=0.5");
        options.wall = wall;
        double area = 0;
        hatching = 0;
        const SheetGroup group = made_sheets::sheetOf(mesh, options).groups[1];
        for (const SheetLayer& layer : group.layers)
            for (const SheetPath& path : layer.paths) {
                hatching += layer.key == "fine";
                const QRectF box = painterPath(path.path).boundingRect();
                if (path.pen_width == 0) area += box.width() * box.height();
            }
        return area;
    };
    std::size_t hatching = 0;
    EXPECT_EQ(areaOf(WallStyle::None, hatching), 0);
    EXPECT_EQ(hatching, 0u);
    EXPECT_EQ(areaOf(WallStyle::Hatched, hatching), 0);
    EXPECT_GT(hatching, 50u);
    EXPECT_NEAR(areaOf(WallStyle::Filled, hatching), 10000, 1);
    EXPECT_EQ(hatching, 0u);
}

}  // namespace
