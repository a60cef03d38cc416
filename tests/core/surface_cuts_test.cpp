// SPDX-License-Identifier: GPL-3.0-or-later
// Lines where surfaces run through each other, not where they touch.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "generators.h"
#include "plain_sight.h"

namespace {

using namespace laplacian_lines;
using namespace plain_sight;
using Eigen::Vector3d;

const Vector3d kAside = {0.7, 0.6, 0.45};

TriangleMesh two_boxes(int cells, int other_cells, const Vector3d& offset,
                       const Eigen::AngleAxisd& turn = Eigen::AngleAxisd(0, Vector3d::UnitX())) {
    TriangleMesh mesh = test_meshes::cube(cells), other = test_meshes::cube(other_cells);
    for (Vector3d& p : other.positions)
        p += offset;
    test_meshes::append(mesh, other);
    for (Vector3d& p : mesh.positions)
        p = turn * p;
    return mesh;
}

double length_of(const SightLine& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
        length += (line.points[i].position - line.points[i - 1].position).norm();
    return length;
}

/// Without extracted lines, creases are the cuts.
std::vector<SightLine> cuts_of(const TriangleMesh& mesh, const View& view, bool has_hidden = true) {
    LineKindSet creases;
    creases[LineKind::Crease] = true;
    return LineVisibility(mesh).look(view, {}, {creases, 1.2, has_hidden, false});
}

double total_length(const std::vector<SightLine>& lines) {
    double length = 0;
    for (const SightLine& line : lines)
        length += length_of(line);
    return length;
}

/// Of [-1, 1]³ and a copy moved by kAside: a hexagon of sides along the axes.
constexpr double kHexagon = 2 * (1.3 + 1.4 + 1.55);

TEST(SurfaceCuts, OfTwoBoxesAreAHexagon) {
    for (const View& view : views_from(special_directions(), {kAside / 2, 4.5})) {
        SCOPED_TRACE(words(view));
        const auto cuts = cuts_of(two_boxes(1, 1, kAside), view);
        EXPECT_NEAR(total_length(cuts), kHexagon, 1e-6);
        for (const SightLine& cut : cuts)
            for (const SightPoint& p : cut.points) {
                EXPECT_NEAR(p.position.maxCoeff(), 1, 1e-6);
                EXPECT_NEAR((p.position - kAside).minCoeff(), -1, 1e-6);
            }
    }
}

TEST(SurfaceCuts, DoNotDependOnTheTriangles) {
    const View view = View::orthographic({0.31, -0.74, 0.59});
    const Eigen::AngleAxisd turn(0.8, Vector3d(1, 2, 3).normalized());
    for (int cells = 1; cells <= 7; ++cells)
        for (int other = 1; other <= 7; other += 2) {
            SCOPED_TRACE(testing::Message() << cells << ", " << other);
            EXPECT_NEAR(total_length(cuts_of(two_boxes(cells, other, kAside), view)), kHexagon,
                        1e-5);
            EXPECT_NEAR(total_length(cuts_of(two_boxes(cells, other, kAside, turn), view)),
                        kHexagon, 1e-5);
        }
}

/// An edge in the plane of a triangle: neither of its triangles has corners on both sides.
TEST(SurfaceCuts, RunAlongEdges) {
    const auto cuts =
        cuts_of(two_boxes(4, 1, {0.7, 0.6, 0.5}), View::orthographic({0.31, -0.74, 0.59}));
    EXPECT_NEAR(total_length(cuts), 2 * (1.3 + 1.4 + 1.5), 1e-6);
}

TEST(SurfaceCuts, AreHiddenAsOtherEdgesAre) {
    const TriangleMesh mesh = two_boxes(2, 3, kAside);
    EXPECT_NEAR(total_length(cuts_of(mesh, View::orthographic({1, 1.1, 1.2}), false)), 0, 1e-6);
    // Two sides of the second box emerge beside the first.
    EXPECT_NEAR(total_length(cuts_of(mesh, View::orthographic({-1, 0.2, 0.1}), false)), 1.4 + 1.55,
                1e-6);
    const auto seen = cuts_of(mesh, View::orthographic({1, -1.1, 1.2}), false);
    ASSERT_FALSE(seen.empty());
    for (const SightLine& line : seen)
        for (const SightPoint& p : line.points)
            EXPECT_NEAR(p.position.y(), -0.4, 1e-6);  // that side of the second box is in sight
}

TEST(SurfaceCuts, AreNoneWhereSurfacesTouch) {
    const Vector3d touching[] = {{2, 0, 0}, {2, 0.5, 0.25}, {2, 2, 2}, {0.3, 0.7, -2}};
    for (const Vector3d& offset : touching)
        for (const int cells : {1, 3})
            for (const double angle : {0., 0.7}) {
                const Eigen::AngleAxisd turn(angle, Vector3d(3, 1, 2).normalized());
                const auto cuts = cuts_of(two_boxes(cells, 2, offset, turn),
                                          View::orthographic({0.31, -0.74, 0.59}), false);
                EXPECT_EQ(total_length(cuts), 0)
                    << offset.transpose() << ", " << cells << ", " << angle;
            }
}

}  // namespace
