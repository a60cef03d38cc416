// SPDX-License-Identifier: GPL-3.0-or-later
// Where lines end, and borders, on every mesh of the registry.
#include <gtest/gtest.h>

#include <algorithm>
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

/// Without exactly two triangles.
LineSet irregular_edges(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> counts;
    for (const Triangle& t : mesh.triangles) {
        if (!helpers::has_area(mesh, t)) continue;
        for (int k = 0; k < 3; ++k)
            ++counts[std::minmax(t[k], t[(k + 1) % 3])];
    }
    LineSet edges;
    for (const auto& [edge, count] : counts) {
        if (count == 2) continue;
        edges.lines.push_back({std::uint32_t(edges.points.size()), 2});
        for (std::uint32_t v : {edge.first, edge.second})
            edges.points.push_back({mesh.positions[v].cast<float>(), 0, 0, 1});
    }
    return edges;
}

TEST_P(Tracing, BordersAreEdgesWithoutTwoTriangles) {
    if (GetParam() == "dirty_torus") return;
    const LineSet borders =
        helpers::extract(LineExtractor(mesh(), precompute(mesh())), View::perspective({3, 2, 4}),
                         helpers::only(LineKind::Border));
    EXPECT_EQ(helpers::edges_of(mesh(), borders),
              helpers::edges_of(mesh(), irregular_edges(mesh())));
    if (GetParam() != "plane") return;
    ASSERT_EQ(borders.lines.size(), 1u);
    EXPECT_TRUE(borders.lines[0].closed);
}

/// On a closed surface a level line has no end, wherever zeros fall.
TEST_P(Tracing, EndsLinesOnlyAtBordersAndJunctions) {
    const Field field = precompute(mesh());
    const LineExtractor extractor(mesh(), field);
    const LineSet edges = irregular_edges(mesh());
    EXPECT_TRUE(edges.lines.empty() || !test_meshes::mesh_named(GetParam()).is_closed);
    for (const View& view : axis_views(3 * field.scale.diagonal)) {
        const LineSet lines = helpers::extract(extractor, view, helpers::all_crossings());
        for (const Polyline& line : lines.lines)
            for (std::uint32_t end : {line.first, line.first + line.count - 1})
                EXPECT_TRUE(line.closed ||
                            helpers::distance_to_lines(lines.points[end].position.cast<double>(),
                                                       edges) < 1e-5 * field.scale.diagonal);
    }
}

}  // namespace
