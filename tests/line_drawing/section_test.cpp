// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "laplacian_lines/error.h"
#include "line_drawing/sheet_file.h"
#include "sections/wall_area.h"
#include "sheet_helpers.h"

using namespace line_drawing;
using laplacian_lines::TriangleMesh;
using sheet_helpers::cube_of100;
using sheet_helpers::layer_of;
using sheet_helpers::painter_path;
using sheet_helpers::sheet_of;
using sheet_helpers::with_sections;
using test_meshes::moved;

namespace {

/// The section alone, at 1:1, without hatching.
SheetGroup section_of(const TriangleMesh& mesh, const char* section) {
    SheetOptions options = with_sections("", section);
    options.wall = WallStyle::None;
    return sheet_of(mesh, options).groups.at(0);
}

int open_paths_of(const SheetGroup& section) {
    int count = 0;
    for (const SheetPath& path : layer_of(section, "section").paths)
        count += path.path.pieces.front().end != path.path.pieces.back().end;
    return count;
}

/// The area that is drawn and the number of hatching lines.
std::pair<double, std::size_t> wall_of(const TriangleMesh& mesh, const char* section,
                                       WallStyle wall) {
    SheetOptions options = with_sections("", section);
    options.wall = wall;
    const SheetGroup group = sheet_of(mesh, options).groups.at(0);
    double area = 0;
    std::size_t hatching = 0;
    for (const SheetLayer& layer : group.layers)
        for (const SheetPath& path : layer.paths) {
            hatching += layer.key == "fine";
            if (path.pen_width == 0) area += sheet_helpers::area_of(path);
        }
    return {area, hatching};
}

TEST(Sections, OfASphereAreCircles) {
    const TriangleMesh ball = moved(test_meshes::sphere(5).mesh, {3, 4, 5}, 40);
    for (const char* section : {"x=0.8", "y=0.8", "z=0.8"}) {
        const SheetGroup group = section_of(ball, section);
        EXPECT_EQ(layer_of(group, "section").paths.size(), 1u);
        EXPECT_EQ(open_paths_of(group), 0);
        EXPECT_NEAR(sheet_helpers::length_of(layer_of(group, "section")), 2 * M_PI * 0.8 * 40, 0.5);
    }
}

TEST(Sections, HaveTheAreaOfTheWall) {
    const TriangleMesh torus = moved(test_meshes::torus(180, 90).mesh, {0, 0, 0}, 30);
    const auto [area, hatching] = wall_of(torus, "z=0.5", WallStyle::Filled);
    EXPECT_EQ(layer_of(section_of(torus, "z=0.5"), "section").paths.size(), 2u);
    EXPECT_NEAR(area, M_PI * (42 * 42 - 18 * 18), 0.01 * area);
    EXPECT_EQ(hatching, 0u);
}

TEST(Sections, OfASoupAreTheSame) {
    const TriangleMesh mesh = moved(test_meshes::bumpy_sphere(4).mesh, {0, 0, 0}, 50);
    const auto draw = [](const TriangleMesh& drawn) {
        return write_sheet(sheet_of(drawn, with_sections("", "y=0.4")), ".svg");
    };
    EXPECT_EQ(draw(test_meshes::cut_apart(mesh)), draw(mesh));
}

TEST(Sections, ThroughVerticesAreClosedToo) {
    const SheetGroup group = section_of(cube_of100(), "z=0.5");
    EXPECT_EQ(open_paths_of(group), 0);
    EXPECT_NEAR(sheet_helpers::length_of(layer_of(group, "section")), 400, 1e-3);
}

TEST(Sections, OfOpenSurfacesAreOpen) {
    const TriangleMesh half = moved(test_meshes::half_torus(60, 30).mesh, {0, 0, 0}, 30);
    EXPECT_EQ(open_paths_of(section_of(half, "z=0.51")), 2);
}

TEST(Sections, AreRead) {
    const std::vector<Section> sections = parse_sections("y=0.5, Z=.25");
    ASSERT_EQ(sections.size(), 2u);
    EXPECT_EQ(std::pair(sections[0].axis, sections[0].share), std::pair(1, 0.5));
    EXPECT_EQ(std::pair(sections[1].axis, sections[1].share), std::pair(2, 0.25));
    EXPECT_TRUE(parse_sections("").empty());
    for (const char* words : {"y", "0.5", "w=0.5", "y=0", "y=1", "y=nan", "y=0.5=1"})
        EXPECT_THROW(parse_sections(words), laplacian_lines::Error) << words;
    for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z})
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(std::abs(frame_of_section({axis, 0.5}, up).towards_viewer[axis]), 1);
}

TEST(Walls, AreHatchedFilledOrEmpty) {
    EXPECT_EQ(wall_of(cube_of100(), "x=0.5", WallStyle::None), std::pair(0., std::size_t(0)));
    const auto [no_area, hatching] = wall_of(cube_of100(), "x=0.5", WallStyle::Hatched);
    EXPECT_EQ(no_area, 0);
    EXPECT_GT(hatching, 80u);
    const auto [area, none] = wall_of(cube_of100(), "x=0.5", WallStyle::Filled);
    EXPECT_NEAR(area, 10000, 1);
    EXPECT_EQ(none, 0u);
}

TEST(Walls, AreHatchedWithFinePens) {
    for (const Weights weights : {Weights::Illustrator, Weights::Iso})
        for (const StrokeStyle strokes : {StrokeStyle::Tapered, StrokeStyle::Plain}) {
            SheetOptions options = with_sections("", "x=0.5");
            options.pens = pens_of(weights);
            options.strokes = strokes;
            const Sheet sheet = sheet_of(cube_of100(), options);
            const auto& lines = layer_of(sheet.groups[0], "fine").paths;
            ASSERT_GT(lines.size(), 80u);
            for (const SheetPath& line : lines)
                EXPECT_NEAR(line.pen_width, options.pens[std::size_t(LineClass::Fine)], 1e-9);
        }
}

/// Of a view, without its marks.
QRectF surface_of(SheetGroup view) {
    if (view.layers.back().key == "marks") view.layers.pop_back();
    return sheet_helpers::extent_of(view);
}

TEST(SectionMarks, StandWhereThePlaneIsBesideTheSurfaceAndOnThePaper) {
    SheetOptions options = with_sections("front,left,top", "x=0.3 y=0.5 z=0.6");
    options.paper = "fit";
    const Sheet sheet = sheet_of(cube_of100(), options);
    const QRectF paper = sheet_helpers::paper_of(sheet.size);
    for (std::size_t view = 0; view < 3; ++view) {
        const SheetLayer& marks = layer_of(sheet.groups[view], "marks");
        EXPECT_EQ(marks.texts.size(), 4u);
        EXPECT_EQ(marks.paths.size(), 12u);
        const QRectF surface = surface_of(sheet.groups[view]);
        EXPECT_NEAR(surface.width(), 100, 0.1);
        int at_plane = 0;  // of the front: x = 0.3, or z = 0.6 from below
        for (const SheetPath& path : marks.paths) {
            const QRectF mark =
                painter_path(path.path).boundingRect().adjusted(-0.25, -0.25, 0.25, 0.25);
            EXPECT_FALSE(mark.intersects(surface));
            EXPECT_TRUE(paper.contains(mark));
            at_plane += std::abs(mark.center().x() - surface.left() - 30) < 0.1 ||
                        std::abs(surface.bottom() - mark.center().y() - 60) < 0.1;
        }
        if (view == 0) {
            EXPECT_GE(at_plane, 4);
        }
        for (const SheetText& text : marks.texts) {
            EXPECT_FALSE(surface.contains(text.position.x(), text.position.y()));
            EXPECT_TRUE(paper.contains(text.position.x(), text.position.y()));
        }
    }
}

TEST(SectionMarks, AreNearTheSurfaceOfATurnedView) {
    const TriangleMesh rod = test_meshes::stacked({{50, 10, 0}, {50, 10, 20}});
    const SheetGroup view = sheet_of(rod, with_sections("30,90", "x=0.3")).groups.at(0);
    const QRectF near = surface_of(view).adjusted(-10, -10, 10, 10);
    EXPECT_EQ(layer_of(view, "marks").paths.size(), 6u);
    for (const SheetPath& path : layer_of(view, "marks").paths)
        EXPECT_TRUE(near.contains(painter_path(path.path).boundingRect()));
}

TEST(SectionMarks, GiveSectionsTheirNames) {
    const Sheet marked = sheet_of(cube_of100(), with_sections("front", "x=0.3 z=0.6"));
    EXPECT_EQ(marked.groups[1].name, "A–A");
    EXPECT_EQ(marked.groups[2].name, "B–B");
    EXPECT_EQ(section_of(cube_of100(), "x=0.3").name, "Section x = 30 %");
    EXPECT_EQ(letter_of(25), "Z");
    EXPECT_EQ(letter_of(53), "BB");
}

/// A loop that begins within the wall of another.
TEST(WallAreas, LeaveOpenWhatTheyCut) {
    const WallArea area({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}});
    DrawnLine loop{LineClass::Section, true, {}};
    for (const Eigen::Vector2d& corner :
         std::vector<Eigen::Vector2d>{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}})
        loop.points.push_back({corner});
    const std::vector<DrawnLine> rest = without_parts_in(area, {loop});
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_FALSE(rest[0].closed);
    EXPECT_EQ(rest[0].points.front().position, Eigen::Vector2d(1, 0));
    EXPECT_EQ(rest[0].points.back().position, Eigen::Vector2d(0, 1));
}

}  // namespace
