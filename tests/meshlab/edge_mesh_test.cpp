// SPDX-License-Identifier: GPL-3.0-or-later
// Edge meshes hold the core's line set.
#include <gtest/gtest.h>

#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "meshlab_host/edge_mesh.h"
#include "registry.h"

namespace {

using namespace laplacian_lines;

LineSet bumpy_lines() {
    const auto bumps = test_meshes::mesh_named("bumpy_sphere").mesh;
    const LineExtractor extractor(bumps, precompute(bumps));
    ExtractionScratch scratch;
    LineSet lines;
    LineStyle style;
    style.detail = 90;
    extractor.extract(View::perspective({0.5, -2, 3}), style, scratch, lines);
    return lines;
}

std::vector<Scalarm> column(CMeshO& mesh, const char* name) {
    using Allocator = vcg::tri::Allocator<CMeshO>;
    auto handle = Allocator::FindPerVertexAttribute<Scalarm>(mesh, std::string(name));
    EXPECT_TRUE(Allocator::IsValidHandle(mesh, handle)) << name;
    std::vector<Scalarm> values;
    for (auto& vertex : mesh.vert)
        values.push_back(handle[vertex]);
    return values;
}

void expect_point(const CVertexO& vertex, const LinePoint& point) {
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(vertex.cP()[axis], point.position[axis]);
    EXPECT_EQ(vertex.cQ(), point.weight * point.opacity);
}

TEST(EdgeMesh, HoldsTheLineSet) {
    const LineSet lines = bumpy_lines();
    CMeshO mesh;
    meshlab_host::to_edge_mesh(lines, mesh);
    ASSERT_EQ(std::size_t(mesh.en), lines.segment_count());
    EXPECT_EQ(mesh.fn, 0);
    const auto number = column(mesh, "ll_line"), kind = column(mesh, "ll_kind"),
               strength = column(mesh, "ll_strength"), slope = column(mesh, "ll_slope"),
               weight = column(mesh, "ll_weight"), gradient = column(mesh, "ll_gradient"),
               opacity = column(mesh, "ll_opacity");
    std::size_t edge = 0, closed = 0, kinds = 0;
    std::vector<bool> used(mesh.vert.size());
    for (std::size_t l = 0; l < lines.lines.size(); ++l) {
        const Polyline& line = lines.lines[l];
        closed += line.closed;
        kinds |= std::size_t(1) << int(line.kind);
        for (std::uint32_t i = 0; i + 1 < line.count; ++i, ++edge)
            for (int end = 0; end < 2; ++end) {
                const LinePoint& point = lines.points[line.first + i + std::uint32_t(end)];
                const CVertexO& vertex = *mesh.edge[edge].cV(end);
                const std::size_t v = vcg::tri::Index(mesh, vertex);
                used[v] = true;
                // A closed line's last point is at its first vertex.
                EXPECT_EQ(vertex.cP()[0], point.position.x());
                if (end == 1 && line.closed && i + 2 == line.count) continue;
                expect_point(vertex, point);
                EXPECT_EQ(number[v], Scalarm(l));
                EXPECT_EQ(kind[v], Scalarm(int(line.kind)));
                EXPECT_EQ(strength[v], line.strength);
                EXPECT_EQ(slope[v], line.slope);
                EXPECT_EQ(weight[v], point.weight);
                EXPECT_EQ(gradient[v], point.gradient);
                EXPECT_EQ(opacity[v], point.opacity);
            }
    }
    EXPECT_EQ(mesh.vert.size(), lines.points.size() - closed);
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
    EXPECT_GT(closed, 0u);
    EXPECT_EQ(kinds & 3u, 3u);
    EXPECT_FALSE(mesh.bbox.IsNull());
}

TEST(EdgeMesh, HasTheNormalsOfTheSurface) {
    auto bumps = test_meshes::mesh_named("bumpy_sphere").mesh;
    PrecomputeOptions unsmoothed;
    unsmoothed.normal_smoothing = NormalSmoothing::None;
    const Field field = precompute(bumps, unsmoothed);
    const LineSet lines = bumpy_lines();
    CMeshO mesh;
    meshlab_host::to_edge_mesh(lines, mesh);
    meshlab_host::set_normals(bumps, mesh);
    ASSERT_GT(mesh.vert.size(), 100u);
    for (const CVertexO& vertex : mesh.vert) {
        const Eigen::Vector3d point(vertex.cP()[0], vertex.cP()[1], vertex.cP()[2]);
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < bumps.positions.size(); ++i)
            if ((bumps.positions[i] - point).norm() < (bumps.positions[nearest] - point).norm())
                nearest = i;
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(vertex.cN()[axis], field.normals[nearest][axis], 1e-5);
    }
}

TEST(EdgeMesh, VerticesWithoutNormalsAreNotTheSurface) {
    auto bumps = test_meshes::mesh_named("bumpy_sphere").mesh;
    const LineSet lines = bumpy_lines();
    for (const LinePoint& point : lines.points)  // in no triangle, just where the lines are
        bumps.positions.push_back(point.position.cast<double>());
    bumps.positions.emplace_back(NAN, 0, 0);
    CMeshO mesh;
    meshlab_host::to_edge_mesh(lines, mesh);
    meshlab_host::set_normals(bumps, mesh);
    for (const CVertexO& vertex : mesh.vert)
        EXPECT_NEAR(vertex.cN().Norm(), 1, 1e-5);
}

TEST(EdgeMesh, HasTheColorsOfTheKinds) {
    const LineSet lines = bumpy_lines();
    meshlab_host::KindColors colors{};
    for (std::size_t kind = 0; kind < colors.size(); ++kind)
        colors[kind] = qRgb(int(10 + kind), int(20 + kind), int(30 + kind));
    CMeshO mesh;
    meshlab_host::to_edge_mesh(lines, mesh);
    meshlab_host::set_colors(lines, colors, mesh);
    const auto kind = column(mesh, "ll_kind");
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
        const int number = int(kind[v]);
        EXPECT_EQ(mesh.vert[v].cC(), vcg::Color4b(10 + number, 20 + number, 30 + number, 255));
    }
}

TEST(EdgeMesh, IsEmptyWithoutLines) {
    CMeshO mesh;
    meshlab_host::to_edge_mesh({}, mesh);
    meshlab_host::set_normals({}, mesh);
    EXPECT_EQ(mesh.vn, 0);
    EXPECT_EQ(mesh.en, 0);
}

}  // namespace
