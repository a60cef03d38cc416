// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of the surface across clusters' borders, their turn, and stretches of lines.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>
#include <vector>

#include "fixed/section_profile.h"
#include "fixed/stretches.h"
#include "generators.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;

constexpr float kDegrees = 57.29577951308232f;

/// A mesh as a redraw reads it.
struct Placed {
    explicit Placed(const TriangleMesh& mesh)
        : data(build_extractor_data(mesh, precompute(mesh))),
          placed(place_clusters(data)),
          sides(data, placed) {}

    std::vector<MeshSide> all_sides() const {
        std::vector<MeshSide> all;
        for (std::uint32_t c = 0; c < placed.size(); ++c)
            for (unsigned t = 0; t < placed[c].cluster->triangle_count; ++t)
                for (unsigned k = 0; k < 3; ++k)
                    all.push_back({c, std::uint8_t(t), std::uint8_t(k)});
        return all;
    }
    /// Of the mesh.
    std::pair<std::uint32_t, std::uint32_t> ends(const MeshSide& side) const {
        const PlacedCluster& cluster = placed[side.cluster];
        const auto& corners = cluster.triangle(side.triangle).corners;
        return {cluster.vertices[corners[side.side]],
                cluster.vertices[corners[(side.side + 1) % 3]]};
    }

    ExtractorData data;
    std::vector<PlacedCluster> placed;
    MeshSides sides;
};

TEST(MeshSides, LeadToTheTriangleBeyond) {
    const Placed mesh(test_meshes::torus(40, 30).mesh);
    ASSERT_GT(mesh.placed.size(), 4u);
    std::size_t to_others = 0;
    for (const MeshSide& side : mesh.all_sides()) {
        const MeshSide across = mesh.sides.across(side);
        ASSERT_TRUE(across.exists());
        const auto [a, b] = mesh.ends(side);
        EXPECT_EQ(mesh.ends(across), std::make_pair(b, a));
        to_others += across.cluster != side.cluster;
    }
    EXPECT_GT(to_others, 100u);
}

TEST(MeshSides, EndAtBorders) {
    const int cells = 20;
    const Placed mesh(test_meshes::plane(cells));
    int ends = 0;
    for (const MeshSide& side : mesh.all_sides())
        ends += !mesh.sides.across(side).exists();
    EXPECT_EQ(ends, 4 * cells);
}

/// Across the axis, from every place that has one.
TEST(SectionProfile, TurnsEvenlyOnACylinder) {
    const Placed mesh(test_meshes::cylinder(96, 24).mesh);
    const float radius = 1 / float(mesh.data.diagonal);
    const SectionProbe probe(mesh.placed, mesh.sides);
    SectionProfile profile;
    int measured = 0;
    for (const MeshSide& side : mesh.all_sides()) {
        const PlacedCluster& cluster = mesh.placed[side.cluster];
        const auto position = [&](int k) -> Eigen::Vector3f {
            const auto corner = cluster.triangle(side.triangle).corners[(side.side + k) % 3];
            return Eigen::Map<const Eigen::Vector3f>(cluster.records[corner].position);
        };
        const Eigen::Vector3f point = (position(0) + position(1)) / 2;
        const Eigen::Vector3f normal(point.x(), point.y(), 0), axis = Eigen::Vector3f::UnitZ();
        // The smoothed normals lean at the borders; edges along the section are of no use.
        if (std::abs(point.z()) > 0.6f * radius ||
            std::abs((position(1) - position(0)).z()) < 1e-3f)
            continue;
        ++measured;
        probe.measure({side, point, normal, axis.cross(normal).normalized()}, 0.1f, profile);
        for (const float distance : {-0.1f, -0.03f, 0.04f, 0.1f}) {
            EXPECT_NEAR(profile.angle(distance), distance / radius * kDegrees, 0.7);
            const Eigen::Vector3f there = profile.position(distance);
            EXPECT_NEAR(there.head<2>().norm(), radius, 0.003f * radius);
            EXPECT_NEAR(there.z(), point.z(), 1e-5);
            EXPECT_GT((there - point).dot(axis.cross(normal)) * distance, 0);
        }
        EXPECT_NEAR(profile.middle(0.1f), 0, 0.003);
    }
    EXPECT_GT(measured, 1000);
}

TEST(SectionProfile, EndsWithTheSurface) {
    const Placed mesh(test_meshes::plane(10));
    const SectionProbe probe(mesh.placed, mesh.sides);
    SectionProfile profile;
    for (const MeshSide& side : mesh.all_sides())
        if (!mesh.sides.across(side).exists()) {
            const PlacedCluster& cluster = mesh.placed[side.cluster];
            const auto& corners = cluster.triangle(side.triangle).corners;
            const Eigen::Vector3f a =
                Eigen::Map<const Eigen::Vector3f>(cluster.records[corners[side.side]].position);
            const Eigen::Vector3f b = Eigen::Map<const Eigen::Vector3f>(
                cluster.records[corners[(side.side + 1) % 3]].position);
            const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
            const Eigen::Vector3f inwards = up.cross(b - a).normalized();
            const Eigen::Vector3f middle = (a + b) / 2;
            probe.measure({side, middle, up, inwards}, 0.1f, profile);
            EXPECT_NEAR((profile.position(0.1f) - middle - 0.1f * inwards).norm(), 0, 1e-5);
            EXPECT_EQ(profile.position(-0.1f), middle);
            EXPECT_NEAR(profile.angle(-0.1f), 0, 1e-3);
        }
}

std::vector<LinePoint> points_with(const std::vector<float>& gradients) {
    std::vector<LinePoint> points;
    for (std::size_t i = 0; i < gradients.size(); ++i)
        points.push_back({{float(i), 0, 0}, 1, gradients[i], 1});
    return points;
}

std::vector<std::vector<std::uint32_t>> stretches(const std::vector<float>& gradients,
                                                  bool closed) {
    Polyline line;
    line.count = std::uint32_t(gradients.size());
    line.closed = closed;
    std::vector<std::vector<std::uint32_t>> found;
    for_each_stretch(line, points_with(gradients).data(), 1, [&](const Stretch& stretch) {
        found.emplace_back();
        for (std::uint32_t i = 0; i < stretch.count; ++i)
            found.back().push_back(stretch.point(i));
    });
    return found;
}

using Numbers = std::vector<std::vector<std::uint32_t>>;

TEST(Stretches, AreWhereAllPointsHaveEnough) {
    EXPECT_EQ(stretches({0, 1, 2, 0, 0, 1, 0, 3}, false), (Numbers{{1, 2}, {5}, {7}}));
    EXPECT_EQ(stretches({0, 0}, false), Numbers());
    EXPECT_EQ(stretches({2, 2}, false), (Numbers{{0, 1}}));
}

TEST(Stretches, RunOverTheEndOfClosedLines) {
    EXPECT_EQ(stretches({1, 0, 0, 1, 2, 1}, true), (Numbers{{3, 4, 0}}));
    EXPECT_EQ(stretches({0, 1, 1, 0}, true), (Numbers{{1, 2}}));
    EXPECT_EQ(stretches({1, 1, 1, 1}, true), (Numbers{{0, 1, 2, 0}}));
    EXPECT_EQ(stretches({0, 0, 0}, true), Numbers());
}

TEST(Stretches, KnowTheirLongestStrongPart) {
    const std::vector<LinePoint> points = points_with({5, 5, 1, 5, 5, 5, 1, 1});
    const StretchLengths lengths = measure({0, 8, 8, false}, points.data(), 5, 10);
    EXPECT_FLOAT_EQ(lengths.all, 0.7f);
    EXPECT_FLOAT_EQ(lengths.strong, 0.2f);
}

}  // namespace
