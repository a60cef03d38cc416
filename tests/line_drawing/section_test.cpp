// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/section.h"

#include <gtest/gtest.h>

#include <cmath>

#include "laplacian_lines/error.h"
#include "made_sheets.h"
#include "planes/cutting.h"

using namespace line_drawing;

namespace {

double lengthOf(const Cut& cut) {
    double length = 0;
    for (std::size_t i = 1; i < cut.size(); ++i)
        length += (cut[i] - cut[i - 1]).norm();
    return length;
}

laplacian_lines::TriangleMesh soupOf(const laplacian_lines::TriangleMesh& mesh) {
    laplacian_lines::TriangleMesh soup;
    for (const auto& t : mesh.triangles) {
        const auto first = std::uint32_t(soup.positions.size());
        for (const std::uint32_t v : t)
            soup.positions.push_back(mesh.positions[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

TEST(Sections, OfASphereAreCircles) {
    const auto mesh = test_meshes::sphere(5).mesh;
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<Cut> cuts = cutMesh(mesh, axis, 0.6);
        ASSERT_EQ(cuts.size(), 1u);
        EXPECT_EQ(cuts[0].front(), cuts[0].back());
        EXPECT_NEAR(lengthOf(cuts[0]), 2 * M_PI * 0.8, 0.01);
        for (const Eigen::Vector3d& p : cuts[0])
            EXPECT_EQ(p[axis], 0.6);
    }
}

TEST(Sections, OfATorusAreTwoLoopsThatTurnOppositely) {
    const std::vector<Cut> cuts = cutMesh(test_meshes::torus(90, 45).mesh, 2, 0.01);
    ASSERT_EQ(cuts.size(), 2u);
    double area[2] = {0, 0};
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(cuts[std::size_t(i)].front(), cuts[std::size_t(i)].back());
        const Cut& cut = cuts[std::size_t(i)];
        for (std::size_t k = 1; k < cut.size(); ++k)
            area[i] += (cut[k - 1].x() * cut[k].y() - cut[k - 1].y() * cut[k].x()) / 2;
    }
    EXPECT_LT(area[0] * area[1], 0);
}

TEST(Sections, OfASoupAreTheSame) {
    const auto mesh = test_meshes::bumpy_sphere(4).mesh;
    const auto whole = cutMesh(mesh, 1, 0.1), soup = cutMesh(soupOf(mesh), 1, 0.1);
    ASSERT_EQ(soup.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i)
        EXPECT_EQ(soup[i], whole[i]);
}

TEST(Sections, ThroughVerticesAreClosedToo) {
    const std::vector<Cut> cuts = cutMesh(test_meshes::cube(4), 2, 0);
    ASSERT_EQ(cuts.size(), 1u);
    EXPECT_EQ(cuts[0].front(), cuts[0].back());
    EXPECT_NEAR(lengthOf(cuts[0]), 8, 1e-12);
}

TEST(Sections, OfOpenSurfacesAreOpen) {
    const std::vector<Cut> cuts = cutMesh(test_meshes::half_torus(60, 30).mesh, 2, 0.01);
    ASSERT_EQ(cuts.size(), 2u);
    for (const Cut& cut : cuts)
        EXPECT_NE(cut.front(), cut.back());
}

TEST(Sections, BesideTheMeshAreEmpty) {
    EXPECT_TRUE(cutMesh(test_meshes::cube(2), 0, 5).empty());
}

TEST(Hatching, FillsWhatIsBetweenLoops) {
    const auto square = [](double half) {
        return std::vector<Eigen::Vector2d>{
            {-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}};
    };
    const double spacing = 0.1;
    double length = 0;
    for (const auto& line : hatch({{square(5), square(2)}}, {1, 0}, spacing)) {
        ASSERT_EQ(line.size(), 2u);
        length += (line[1] - line[0]).norm();
        EXPECT_TRUE(std::abs(line[0].y()) > 2 || std::abs(line[0].x()) >= 2);
    }
    EXPECT_NEAR(length * spacing, 100 - 16, 0.5);
    EXPECT_TRUE(hatch({}, {1, 0}, spacing).empty());
}

TEST(Sections, AreNamed) {
    const std::vector<Section> sections = parseSections("y=0.5, Z=.25");
    ASSERT_EQ(sections.size(), 2u);
    EXPECT_EQ(sections[0].axis, 1);
    EXPECT_EQ(sections[1].share, 0.25);
    EXPECT_TRUE(parseSections("").empty());
    for (const char* words : {"y", "0.5", "w=0.5", "y=0", "y=1", "y=nan", "y=0.5=1"})
        EXPECT_THROW(parseSections(words), laplacian_lines::Error) << words;
}

TEST(Sections, AreSeenAcrossTheirAxes) {
    for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z})
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(std::abs(frameOfSection({axis, 0.5}, up).towards_viewer[axis]), 1);
}

TEST(Sections, AreDrawnAtScaleWithHatching) {
    SheetOptions options = made_sheets::plainViews("front");
    options.sections = parseSections("x=0.5");
    options.up = UpAxis::Z;
    const Sheet sheet = made_sheets::sheetOf(made_sheets::cubeOf100(), options);
    const SheetGroup& group = sheet.groups.at(1);
    EXPECT_NEAR(made_sheets::extentOf(group).width(), 100, 0.02);
    EXPECT_NEAR(made_sheets::extentOf(group).height(), 100, 0.02);
    std::size_t section = 0, hatching = 0;
    for (const SheetLayer& layer : group.layers)
        (layer.key == "section" ? section : hatching) += layer.paths.size();
    EXPECT_EQ(section, 1u);
    EXPECT_GT(hatching, 50u);
}

}  // namespace
