// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of traced lines on every mesh of the registry.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using test_meshes::MeshEntry;
using test_meshes::TestMesh;

class Tracing : public testing::TestWithParam<const MeshEntry*> {
protected:
    const TestMesh& test_mesh() const { return GetParam()->get(); }
    const TriangleMesh& mesh() const { return GetParam()->get().mesh; }
};

INSTANTIATE_TEST_SUITE_P(Meshes, Tracing, testing::ValuesIn(test_meshes::meshes_with(0)),
                         [](const auto& info) { return info.param->name; });

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

void expect_sound(const LineSet& lines, double diagonal) {
    std::uint32_t next = 0;
    for (const Polyline& line : lines.lines) {
        EXPECT_EQ(line.first, next);  // lines follow each other without gaps
        EXPECT_GE(line.count, 2u);
        next = line.first + line.count;
        ASSERT_LE(next, lines.points.size());
        const LinePoint *begin = &lines.points[line.first], *last = &lines.points[next - 1];
        if (line.closed) {
            EXPECT_EQ(begin->position, last->position);
            EXPECT_EQ(begin->gradient, last->gradient);
            EXPECT_EQ(begin->weight, last->weight);
        }
        double length = 0, strength = 0;
        for (const LinePoint* p = begin; p < last; ++p) {
            const double step = (p[1].position - p[0].position).norm() / diagonal;
            length += step;
            strength += (p[0].gradient + p[1].gradient) / 2 * step;
        }
        EXPECT_NEAR(line.length, length, 1e-4 * length + 1e-5);
        if (line.kind == LineKind::Laplacian || line.kind == LineKind::Contour) {
            EXPECT_NEAR(line.strength, strength, 1e-4 * strength + 1e-4);
        }
    }
    EXPECT_EQ(next, lines.points.size());
    for (const LinePoint& p : lines.points)
        EXPECT_TRUE(p.position.allFinite() && p.gradient >= 0 && p.weight >= 0 && p.weight <= 1);
}

TEST_P(Tracing, LinesAreSoundFromAllViews) {
    const Field field = precompute(mesh());
    const LineExtractor extractor(mesh(), field);
    std::vector<View> views = helpers::random_views(mesh(), 10);
    for (const View& view : axis_views(3 * field.scale.diagonal))
        views.push_back(view);
    LineStyle unsmoothed;  // whose points are the crossings that lengths are measured between
    unsmoothed.line_smoothing = 0;
    for (const View& view : views)
        for (const LineStyle& style : {unsmoothed, helpers::all_crossings()})
            expect_sound(helpers::extract(extractor, view, style), field.scale.diagonal);
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

/// On a closed surface a level line has no end, wherever zeros fall.
TEST_P(Tracing, EndsLinesOnlyAtBordersAndJunctions) {
    const Field field = precompute(mesh());
    const LineExtractor extractor(mesh(), field);
    const LineSet edges = irregular_edges(mesh());
    EXPECT_EQ(edges.lines.empty(), test_mesh().has(test_meshes::kClosed) ||
                                       test_mesh().name == "flipped_torus" ||
                                       test_mesh().name == "dirty_torus");
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
