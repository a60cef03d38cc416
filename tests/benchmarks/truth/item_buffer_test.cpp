// SPDX-License-Identifier: GPL-3.0-or-later
// The item buffer and what is counted at its borders, on forms whose outlines are known.
#include "item_buffer.h"

#include <gtest/gtest.h>

#include "cube_directions.h"
#include "generators.h"

namespace {

using namespace benchmarks;
using laplacian_lines::TriangleMesh;

const PlaneFrame from_above = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TriangleMesh square_at(double z, double half) {
    TriangleMesh mesh = test_meshes::plane(3);
    for (Eigen::Vector3d& p : mesh.positions)
        p = {half * p.x(), half * p.y(), z};
    return mesh;
}

DrawnPaths outline_of_square(double half) {
    return {
        {{{-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}}, true, true}};
}

TEST(ItemBuffer, HasTheBorderOfABallWithinAPixel) {
    TriangleMesh ball = test_meshes::icosphere(5);
    for (Eigen::Vector3d& p : ball.positions)
        p *= 10;
    for (const NamedFrame& direction : few_directions()) {
        const PlaneLine border = ItemBuffer(ball, direction.frame, {}).border();
        ASSERT_GT(border.size(), 1000u);
        for (const PlanePoint& p : border)
            EXPECT_NEAR(p.norm(), 10, 0.06) << direction.name;
    }
}

TEST(ItemBuffer, HasNoHolesBetweenTriangles) {
    const ItemBuffer items(test_meshes::plane(37, 0.3), from_above, {5, {0, 0, 0}});
    for (const PlanePoint& p : items.border())
        EXPECT_GT(p.cwiseAbs().maxCoeff(), 4.9);
}

TEST(ItemBuffer, HasTheDepthOfWhatIsInFront) {
    TriangleMesh squares = square_at(3, 5);
    test_meshes::append(squares, square_at(-2, 9));
    const ItemBuffer items(squares, from_above, {2, {0, 0, 1}});
    EXPECT_NEAR(items.depth_at({-7, 4}).value(), 4, 1e-5);
    EXPECT_NEAR(items.depth_at({-14, 4}).value(), -6, 1e-5);
    EXPECT_FALSE(items.depth_at({-19, 4}));
    EXPECT_FALSE(items.depth_at({500, 4}));
}

TEST(ItemBuffer, CoversAFaceThatIsSeenFromItsEdge) {
    const PlaneFrame from_the_side = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    const ItemBuffer items(square_at(0, 5), from_the_side, {});
    EXPECT_NEAR(double(items.border().size()), 2 * 10 * item_pixels_per_mm, 8);
}

TEST(ItemBuffer, ShowsWhatIsInFront) {
    TriangleMesh mesh = square_at(0, 5);
    test_meshes::append(mesh, square_at(2, 2));
    const PlaneLine jumps = ItemBuffer(mesh, from_above, {}).jumps(0.5);
    EXPECT_NEAR(double(jumps.size()), 4 * 4 * item_pixels_per_mm, 8);
    for (const PlanePoint& p : jumps)
        EXPECT_NEAR(p.cwiseAbs().maxCoeff(), 2, 0.5 / item_pixels_per_mm + 1e-9);
    const PlaneFrame from_below = {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    EXPECT_TRUE(ItemBuffer(mesh, from_below, {}).jumps(0.5).empty());
    EXPECT_TRUE(ItemBuffer(mesh, from_above, {}).jumps(2.5).empty());
}

TEST(SilhouetteScores, KnowWhatIsBareAndWhatIsFar) {
    const ItemBuffer items(square_at(0, 5), from_above, {});
    EXPECT_EQ(score_silhouette(items, {}).bare_border, items.border().size());
    EXPECT_EQ(score_silhouette(items, {}).share(), 0);
    const SilhouetteScores aside = score_silhouette(items, outline_of_square(5.3));
    EXPECT_EQ(aside.bare_border, aside.border);
    EXPECT_EQ(aside.share(), 1);
    BarePlaces bare;
    DrawnPaths three_sides = outline_of_square(5);
    three_sides[0].points.pop_back();
    EXPECT_NEAR(score_silhouette(items, three_sides, &bare).share(), 0.75, 0.05);
    for (const PlanePoint& p : bare.border)
        EXPECT_LT(p.x(), -4.9);
}

TEST(SilhouetteScores, KnowJumpsWithoutALine) {
    TriangleMesh mesh = square_at(0, 5);
    test_meshes::append(mesh, square_at(2, 2));
    const ItemBuffer items(mesh, from_above, {});
    DrawnPaths drawing = outline_of_square(5);
    EXPECT_GT(score_silhouette(items, drawing).bare_jumps, 300u);
    drawing.push_back(outline_of_square(2)[0]);
    EXPECT_EQ(score_silhouette(items, drawing).bare_jumps, 0u);
}

TEST(Directions, AreThoseOfACubeExactlyAndAside) {
    for (const NamedFrame& direction : few_directions())
        EXPECT_NEAR(
            (direction.frame.right.cross(direction.frame.up) - direction.frame.viewer).norm(), 0,
            1e-12)
            << direction.name;
    const Eigen::Vector3d exact = direction_named("+-0").frame.viewer;
    EXPECT_NEAR((exact - Eigen::Vector3d(1, -1, 0).normalized()).norm(), 0, 1e-12);
    EXPECT_NEAR((exact - direction_named("+-0 by 1e-6").frame.viewer).norm(), 1e-6, 1e-9);
    EXPECT_NEAR((exact - direction_named("+-0 by 1 degree").frame.viewer).norm(), M_PI / 180, 1e-5);
    EXPECT_NEAR(direction_named("90,0").frame.viewer.x(), 1, 1e-12);
    for (const char* name : {"", "000", "+-", "+-1", "+-0 by 2", "1,2,3", "a,b"})
        EXPECT_THROW(direction_named(name), std::invalid_argument) << name;
}

}  // namespace
