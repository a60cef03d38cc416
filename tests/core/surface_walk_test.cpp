// SPDX-License-Identifier: GPL-3.0-or-later
// Paths over a few triangles, and quads that could be cut the other way.
#include "fixed/surface_walk.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <vector>

#include "fixed/crease_criteria.h"

namespace {

using namespace laplacian_lines;
using Eigen::Vector3f;

/// Triangles of one orientation, as build_triangle_graph() has them.
struct Graph : TriangleGraph {
    Graph(const std::vector<Vector3f>& positions,
          const std::vector<std::array<std::uint32_t, 3>>& corners)
        : places(positions.size()) {
        for (std::size_t v = 0; v < positions.size(); ++v)
            Eigen::Map<Vector3f>(places[v].position) = positions[v];
        records = places.data();
        triangles = std::make_unique<Node[]>(corners.size());
        for (std::uint32_t t = 0; t < corners.size(); ++t) {
            Node& node = triangles[t];
            std::copy(corners[t].begin(), corners[t].end(), node.corners);
            const Vector3f a = position(t, 0), b = position(t, 1), c = position(t, 2);
            node.normal = (b - a).cross(c - a).normalized();
            node.centre = (a + b + c) / 3;
            node.area = (b - a).cross(c - a).norm() / 2;
            node.reversed = 0;
            for (unsigned k = 0; k < 3; ++k)
                node.neighbours[k] = beyond(corners, corners[t][(k + 1) % 3], corners[t][k]);
        }
    }

    static std::uint32_t beyond(const std::vector<std::array<std::uint32_t, 3>>& corners,
                                std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t t = 0; t < corners.size(); ++t)
            for (unsigned k = 0; k < 3; ++k)
                if (corners[t][k] == from && corners[t][(k + 1) % 3] == to) return t;
        return kNone;
    }

    std::vector<VertexRecord> places;
};

/// A strip that narrows towards x = 4, from an edge at x = 0 at which the surface is bent by 5
/// degrees. Its upper border leans by 0.15; the path meets it at x = 10/3.
TEST(SurfaceWalk, GoesOnAlongAWall) {
    const Graph graph({{0, 0, 0}, {0, 1, 0}, {4, 0.4f, 0}, {-1, 0.5f, -0.0875f}},
                      {{0, 2, 1}, {0, 1, 3}});
    const SurfaceWalk walk(graph, {0, 2}, 0);
    const float across = 10 / 3.f, along = Vector3f(4 - across, -0.1f, 0).norm();
    EXPECT_EQ(walk.begin(), 0);
    EXPECT_NEAR(walk.centre(), 4 / 3.f, 0.1);
    EXPECT_NEAR(walk.end(), across + along, 1e-4);
    EXPECT_TRUE(walk.is_at_border());
}

/// An edge of 30 degrees between faces that are bent by a little around it, as those of a form
/// with rounded sides. Cut the other way, the square itself is bent by less than that, but there
/// is a notch: its sides are bent by 21 degrees each instead of 2.
TEST(OtherDiagonal, OfAnEdgeOfTheFormCutsANotch) {
    const auto square = [](float fall, float fall_beyond) {
        const float low = -0.5f * fall, lower = low - 0.5f * fall_beyond;
        return Graph({{0, 0, 0},
                      {1, 0, 0},
                      {0.5f, 0.5f, low},
                      {0.5f, -0.5f, low},
                      {1.5f, 1, lower},
                      {-0.5f, 1, lower},
                      {-0.5f, -1, lower},
                      {1.5f, -1, lower}},
                     {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}, {3, 0, 6}, {1, 3, 7}});
    };
    const float degrees = 0.0174532925f;
    EXPECT_FALSE(is_mere_diagonal(square(std::tan(15 * degrees), std::tan(19 * degrees)), {0, 0}));
    // A dome: all edges are bent alike, and so are those of the other diagonal.
    EXPECT_TRUE(is_mere_diagonal(square(std::tan(3 * degrees), std::tan(12 * degrees)), {0, 0}));
}

}  // namespace
