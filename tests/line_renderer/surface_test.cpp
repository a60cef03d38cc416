// SPDX-License-Identifier: GPL-3.0-or-later
// The surface that a mesh is painted and hides lines with.
#include <gtest/gtest.h>

#include <cmath>

#include "line_renderer/surface.h"

namespace {

using laplacian_lines::Field;
using laplacian_lines::TriangleMesh;

TEST(Surface, HasTheTrianglesWhoseCornersAreFinite) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {NAN, 0, 0}, {1e300, 0, 0}};
    mesh.triangles = {{0, 1, 3}, {0, 1, 2}, {4, 1, 2}, {0, 1, 9}};
    Field field;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        field.normals.push_back({0, 0, float(i)});
    const line_renderer::SurfacePointer surface = line_renderer::make_surface(mesh, field);
    ASSERT_EQ(surface->vertices.size(), mesh.positions.size());
    EXPECT_EQ(surface->vertices[2].position, Eigen::Vector3f(0, 1, 0));
    EXPECT_EQ(surface->vertices[2].normal, Eigen::Vector3f(0, 0, 2));
    ASSERT_EQ(surface->triangles.size(), 1u);
    EXPECT_EQ(surface->triangles[0], (laplacian_lines::Triangle{0, 1, 2}));
    EXPECT_EQ(surface->most_behind, 0);
    mesh.known_edge = 2;
    EXPECT_GT(line_renderer::make_surface(mesh, field)->most_behind, 0.5) << "it was refined";
}

}  // namespace
