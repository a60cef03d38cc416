// SPDX-License-Identifier: GPL-3.0-or-later
// Where lines end, and borders, on every mesh of the registry; borders of a ribbed plate.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;

class Tracing : public testing::TestWithParam<std::string> {
protected:
    const TriangleMesh& mesh() const { return test_meshes::mesh_named(GetParam()).mesh; }
};
INSTANTIATE_TEST_SUITE_P(Meshes, Tracing, testing::ValuesIn(test_meshes::mesh_names()),
                         [](const auto& info) { return info.param; });

/// Functions vanish at whole rows of vertices.
std::vector<View> axis_views(double distance) {
    std::vector<View> views;
    for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1.0, 1.0}) {
            const Eigen::Vector3d direction = side * Eigen::Vector3d::Unit(axis);
            views.push_back(View::orthographic(direction));
            views.push_back(View::perspective(distance * direction));
        }
    return views;
}

/// Edges of one triangle, and of three and more of which two meet at an angle of this cosine or
/// less; by default whatever the angle.
LineSet irregular_edges(const TriangleMesh& mesh, double cosine = 2) {
    std::map<helpers::Edge, std::vector<Eigen::Vector3d>> normals;
    for (const Triangle& t : mesh.triangles) {
        if (!helpers::has_area(mesh, t)) continue;
        const auto& p = mesh.positions;
        for (int k = 0; k < 3; ++k)
            normals[std::minmax(t[k], t[(k + 1) % 3])].push_back(
                (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized());
    }
    LineSet edges;
    for (const auto& [edge, around] : normals) {
        const bool is_bent = std::any_of(around.begin(), around.end(), [&, &all = around](auto& n) {
            return std::any_of(all.begin(), all.end(),
                               [&](auto& other) { return std::abs(n.dot(other)) <= cosine; });
        });
        if (around.size() == 2 || (around.size() > 2 && !is_bent)) continue;
        edges.lines.push_back({std::uint32_t(edges.points.size()), 2});
        for (std::uint32_t v : {edge.first, edge.second})
            edges.points.push_back({mesh.positions[v].cast<float>(), 0, 0, 1});
    }
    return edges;
}

TEST_P(Tracing, BordersAreEdgesOfOneTriangleOrOfSeveralAtAnAngle) {
    const LineSet borders =
        helpers::extract(LineExtractor(mesh(), precompute(mesh())), View::perspective({3, 2, 4}),
                         helpers::only(LineKind::Border));
    EXPECT_EQ(helpers::edges_of(mesh(), borders),
              helpers::edges_of(mesh(), irregular_edges(mesh(), std::cos(40 * M_PI / 180))));
    if (GetParam() != "plane") return;
    ASSERT_EQ(borders.lines.size(), 1u);
    EXPECT_TRUE(borders.lines[0].closed);
}

/// 1 by 1, in strips along y, with ribs of height 0.1 between them, without thickness: chains end
/// at each rib, and between two ribs they are shorter than borders have to be alone.
TriangleMesh ribbed_plate(std::uint32_t strips) {
    TriangleMesh plate;
    for (std::uint32_t i = 0; i <= strips; ++i) {
        const double x = double(i) / strips;
        for (const auto& [y, z] : {std::pair{0., 0.}, {1., 0.}, {0., 0.1}, {1., 0.1}})
            plate.positions.push_back({x, y, z});
        const std::uint32_t foot = 4 * i;
        if (i < strips)
            plate.triangles.insert(plate.triangles.end(),
                                   {{foot, foot + 4, foot + 5}, {foot, foot + 5, foot + 1}});
        if (i > 0 && i < strips)
            plate.triangles.insert(plate.triangles.end(),
                                   {{foot, foot + 1, foot + 3}, {foot, foot + 3, foot + 2}});
    }
    return plate;
}

TEST(Borders, StayBetweenRibs) {
    constexpr std::uint32_t strips = 60;
    const TriangleMesh plate = ribbed_plate(strips);
    const LineSet borders =
        helpers::extract(LineExtractor(plate, precompute(plate)), View::perspective({3, 2, 4}),
                         helpers::only(LineKind::Border));
    const double around = 4, of_rib = 1 + 1 + 2 * 0.1, diagonal = std::sqrt(2 + 0.01);
    EXPECT_NEAR(helpers::total_length(borders), (around + (strips - 1) * of_rib) / diagonal, 1e-4);
}

/// On a closed surface a level line has no end, wherever zeros fall.
TEST_P(Tracing, EndsLinesOnlyAtBordersAndJunctions) {
    const Field field = precompute(mesh());
    const LineExtractor extractor(mesh(), field);
    const LineSet edges = irregular_edges(mesh());
    EXPECT_TRUE(edges.lines.empty() || !test_meshes::mesh_named(GetParam()).is_closed);
    for (const View& view : axis_views(3 * field.scale.diagonal)) {
        const LineSet lines = helpers::extract(extractor, view, helpers::all_crossings());
        EXPECT_TRUE(!lines.lines.empty() || !test_meshes::mesh_named(GetParam()).is_closed);
        for (const Polyline& line : lines.lines)
            for (std::uint32_t end : {line.first, line.first + line.count - 1})
                EXPECT_TRUE(line.closed ||
                            helpers::distance_to_lines(lines.position(lines.points[end]), edges) <
                                1e-5 * field.scale.diagonal);
    }
}

}  // namespace
