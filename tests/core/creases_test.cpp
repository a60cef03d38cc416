// SPDX-License-Identifier: GPL-3.0-or-later
// Creases are the edges of the form, on meshes of few triangles and of many.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "helpers.h"
#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/refinement.h"

namespace {

using namespace laplacian_lines;
using helpers::Edge;
using helpers::edges_of;
using test_meshes::circle;
using test_meshes::moved;
using test_meshes::prism;
using test_meshes::Ring;
using test_meshes::together;

constexpr double kTurn = 6.283185307179586;

LineSet creases_of(const TriangleMesh& mesh,
                   const LineStyle& style = helpers::only(LineKind::Crease),
                   const View& view = View::perspective({3, 2, 4})) {
    return helpers::extract(LineExtractor(mesh, precompute(mesh)), view, style);
}

/// A closed solid around the z axis: rings of as many places each, with a middle at either end.
TriangleMesh joined(const std::vector<Ring>& rings) {
    TriangleMesh mesh = test_meshes::walls(rings);
    const auto sides = std::uint32_t(rings.front().size());
    const auto bottom = std::uint32_t(mesh.positions.size());
    mesh.positions.push_back({0, 0, rings.front().front().z()});
    mesh.positions.push_back({0, 0, rings.back().front().z()});
    const std::uint32_t last = bottom - sides;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        mesh.triangles.push_back({next, i, bottom});
        mesh.triangles.push_back({last + i, last + next, bottom + 1});
    }
    return mesh;
}

/// The same of circles with these radii and heights.
TriangleMesh turned(std::uint32_t sides, const std::vector<std::pair<double, double>>& rings) {
    std::vector<Ring> circles;
    for (const auto& [radius, z] : rings)
        circles.push_back(circle(sides, radius, z));
    return joined(circles);
}

/// A square plate with a hole: triangles between their corners on either side, and walls.
TriangleMesh plate_with_hole(std::uint32_t sides) {
    TriangleMesh mesh;
    for (const double z : {0., 0.2}) {
        const Ring hole = circle(sides, 0.5, z);
        mesh.positions.insert(mesh.positions.end(), hole.begin(), hole.end());
        for (const auto& [x, y] : {std::pair(1, 1), {-1, 1}, {-1, -1}, {1, -1}})
            mesh.positions.push_back({double(x), double(y), z});
    }
    const std::uint32_t layer = sides + 4;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.push_back({layer + a, layer + b, layer + c});
        mesh.triangles.push_back({a, c, b});
    };
    const auto wall = [&](std::uint32_t a, std::uint32_t b) {
        mesh.triangles.push_back({a, b, layer + b});
        mesh.triangles.push_back({a, layer + b, layer + a});
    };
    const auto corner = [&](std::uint32_t i) { return sides + (4 * i + 2) / sides % 4; };
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides, here = corner(i), there = corner(i + 1);
        add(i, here, next);
        if (here != there) add(next, here, there);
        if (here != there) wall(here, there);
        wall(next, i);
    }
    return mesh;
}

/// Edges of a line set that go along the rings of turned() or the polygons of prism().
std::size_t edges_on_rings(const TriangleMesh& mesh, const LineSet& lines) {
    std::size_t count = 0;
    for (const Edge& edge : edges_of(mesh, lines))
        count += mesh.positions[edge.first].z() == mesh.positions[edge.second].z();
    return count;
}

/// The others.
std::size_t edges_along(const TriangleMesh& mesh, const LineSet& lines) {
    return edges_of(mesh, lines).size() - edges_on_rings(mesh, lines);
}

TEST(Creases, AreTheTwelveEdgesOfACubeOfAnyFineness) {
    for (const int cells : {1, 2, 10, 40}) {
        const LineSet lines = creases_of(test_meshes::cube(cells));
        ASSERT_EQ(lines.lines.size(), 12u) << cells;
        for (const Polyline& line : lines.lines) {
            EXPECT_EQ(line.count, std::uint32_t(cells) + 1);
            EXPECT_NEAR(line.length, 2 / std::sqrt(12.), 1e-5);
        }
        for (const LinePoint& p : lines.points) {
            EXPECT_NEAR(p.gradient, 90, 1e-3);
            EXPECT_EQ(p.opacity * p.weight, 1);
        }
    }
}

TEST(Creases, AreNotOnRoundForms) {
    for (int level = 1; level <= 4; ++level)
        EXPECT_TRUE(creases_of(test_meshes::icosphere(level)).lines.empty()) << level;
    for (const int columns : {24, 32, 80})
        EXPECT_TRUE(creases_of(test_meshes::torus(columns, columns / 2).mesh).lines.empty())
            << columns;
}

/// Below the angle of the style: about 22 degrees between a cylinder and a cone on it.
TEST(Creases, AreWeakEdgesBetweenFlatterForms) {
    for (const std::uint32_t sides : {12u, 48u}) {
        const TriangleMesh mesh = turned(sides, {{0.5, -1}, {0.5, 0.5}, {0.3, 1}});
        const LineSet lines = creases_of(mesh);
        EXPECT_EQ(edges_of(mesh, lines).size(), 3 * sides) << sides;
        EXPECT_EQ(edges_on_rings(mesh, lines), 3 * sides);
        LineStyle sharper = helpers::only(LineKind::Crease);
        sharper.crease_angle = 45;
        EXPECT_EQ(edges_of(mesh, creases_of(mesh, sharper)).size(), 2 * sides);
    }
}

/// However small: the walls of a twisted box are bent along their diagonals, which are no creases.
TEST(Creases, DoNotDependOnOtherBodies) {
    const TriangleMesh twisted = joined({circle(4, 1, 0), circle(4, 1, 1.5, 0.2)}),
                       mesh = together(twisted, moved(test_meshes::cube(1), {-100, 0, 0}, 50));
    EXPECT_EQ(edges_of(mesh, creases_of(mesh)).size(), 24u);
}

/// A rod of rings with so many waves around it, whose vertices are not evenly spaced, but in order.
TriangleMesh fluted(int waves, double height, int points, const std::vector<double>& places) {
    std::vector<Ring> rings;
    for (const double z : places) {
        Ring& ring = rings.emplace_back();
        for (int i = 0; i < points; ++i) {
            const double angle = kTurn * (i + 0.5 * std::sin(2.9 * i)) / points;
            const double radius = 1 + height * std::sin(waves * angle);
            ring.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
        }
    }
    return joined(rings);
}

/// Where vertices are far apart, some of the strips between them seem sharper than the others.
TEST(Creases, OfFlutedRodsStandAmongLinesOfTheWholeLengthAlone) {
    std::size_t creases = 0, others = 0;
    const auto expect = [&](const TriangleMesh& rod, double length) {
        const double least = 0.9 * length / measure_scale(rod).diagonal;
        for (const Eigen::Vector3d& eye : {Eigen::Vector3d(0.45, 0.42, 0.78), {0.71, 0.57, 0.41}})
            for (const Polyline& line :
                 creases_of(rod, LineStyle(), View::orthographic(eye)).lines) {
                creases += line.kind == LineKind::Crease;
                if (line.kind == LineKind::Crease || line.kind == LineKind::Contour) continue;
                ++others;
                EXPECT_GT(line.length, least) << describe(line.kind).key;
            }
    };
    expect(fluted(24, 0.05, 24 * 40, {0, 1.5}), 1.5);
    expect(fluted(4, 0.05, 150, {0, 0.7, 1.4, 2}), 2);
    EXPECT_GT(creases, 0u);
    EXPECT_GT(others, 0u);
}

/// A flat roof of three faces is no arc.
TEST(Creases, AreTheEdgesOfRoofs) {
    const TriangleMesh house =
        prism({{-1, 0}, {1, 0}, {1, 1.2}, {0.35, 1.73}, {-0.35, 1.73}, {-1, 1.2}}, 0, 4);
    EXPECT_EQ(edges_along(house, creases_of(house)), 6u);
}

/// Facets turn again and again: however coarse, of cylinders, cones and tori.
TEST(Creases, AreNoFacets) {
    for (const std::uint32_t sides : {10u, 11u, 16u, 30u, 64u}) {
        const TriangleMesh cylinder = turned(sides, {{0.5, -1}, {0.5, 1}}),
                           cone = turned(sides, {{0.5, -1}, {0.1, 0}, {0.1, 1}});
        EXPECT_EQ(edges_of(cylinder, creases_of(cylinder)).size(), 2 * sides) << sides;
        const std::size_t on_rings = edges_on_rings(cone, creases_of(cone));
        EXPECT_EQ(edges_of(cone, creases_of(cone)).size(), on_rings);
        EXPECT_GE(on_rings, 2 * sides);
    }
    for (const int columns : {12, 16, 24})
        EXPECT_TRUE(creases_of(test_meshes::torus(columns, columns).mesh).lines.empty()) << columns;
}

/// The surface turns over and back between vertices that nobody sees apart.
TEST(Creases, AreNoFoldsWithoutWidth) {
    for (const std::uint32_t sides : {16u, 48u}) {
        std::vector<Ring> rings = {circle(sides, 0.5, -1), circle(sides, 0.5, 0),
                                   circle(sides, 0.5, 1)};
        for (Ring& ring : rings) {
            const Eigen::Vector3d p = ring.front();
            ring.push_back({(1 + 1e-6) * p.x(), p.y(), p.z()});
        }
        const TriangleMesh mesh = joined(rings);
        EXPECT_EQ(edges_of(mesh, creases_of(mesh)).size(), 2 * sides) << sides;
    }
}

/// However narrow the face is, and where the circles at its ends are cut at other places.
TEST(Creases, AreNoFacetsOfNarrowChamfers) {
    for (const std::uint32_t sides : {16u, 20u, 32u})
        for (const double width : {0.1, 0.05, 0.02, 0.005})
            for (const double shift : {0., 0.3, 0.5}) {
                const double depth = 0.5 * (1 - std::cos(kTurn / 2 / sides));  // of a facet
                if (shift > 0 && width < 8 * depth)
                    continue;  // triangles are steeper than the face
                const double first = -shift * kTurn / sides;
                const TriangleMesh mesh = joined({circle(sides, 0.5, -1), circle(sides, 0.5, 0.5),
                                                  circle(sides, 0.5 - width, 0.5 + width, first)});
                const LineSet lines = creases_of(mesh);
                EXPECT_EQ(edges_on_rings(mesh, lines), 3 * sides) << width << ' ' << shift;
                EXPECT_EQ(edges_of(mesh, lines).size(), 3 * sides) << width << ' ' << shift;
            }
}

/// A square bar that is twisted, with a row of vertices along the middles of its faces.
TEST(Creases, AreNotTheFacetsOfTwistedFaces) {
    for (const double twist : {4., 6., 9.}) {
        const std::size_t count = 9;
        std::vector<Ring> rings(count);
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < 8; ++k) {
                const double angle = (twist * double(i) / 360 + double(k) / 8) * kTurn;
                const double z = 0.5 * double(i) + (k % 2 && i > 0 && i + 1 < count ? 0.25 : 0);
                rings[i].push_back({(k % 2 ? std::sqrt(0.5) : 1) * std::cos(angle),
                                    (k % 2 ? std::sqrt(0.5) : 1) * std::sin(angle), z});
            }
        const TriangleMesh mesh = joined(rings);
        EXPECT_EQ(edges_of(mesh, creases_of(mesh)).size(), 2 * 8 + 4 * (count - 1)) << twist;
    }
}

/// Between flat faces, however low, and beside facets that turn by more.
TEST(Creases, AreLowEdgesBetweenFlatFaces) {
    for (const double angle : {4., 5., 10., 20., 35.}) {
        const double slope = std::tan(angle / 2 / 360 * kTurn);
        const TriangleMesh mesh = prism({{-1, 0}, {1, 0}, {1, 1}, {0, 1 + slope}, {-1, 1}}, 0, 2);
        EXPECT_EQ(edges_of(mesh, creases_of(mesh)).size(), 15u) << angle;
    }
    for (const std::uint32_t sides : {12u, 24u, 64u}) {  // a chamfer of 45 degrees, and one of 15
        for (const double width : {0.1, 0.1 / std::tan(kTurn / 24)}) {
            const TriangleMesh mesh = turned(sides, {{0.5, -1}, {0.5, 0.5}, {0.4, 0.5 + width}});
            EXPECT_EQ(edges_of(mesh, creases_of(mesh)).size(), 3 * sides) << sides << ' ' << width;
        }
    }
}

/// Faces of two triangles each: no edge between two of them is the diagonal of another quad, and
/// the face on top is not a facet of an arc of three, be its neighbours as wide as it or not.
TEST(Creases, AreTheLowEdgesOfPyramids) {
    for (const double top : {0.15, 0.25, 0.4, 0.5})
        for (const double height : {0.05, 0.1, 0.2})
            for (const unsigned diagonals : {0u, 0x3ffu, 0x155u, 0x2ccu}) {
                const TriangleMesh mesh = test_meshes::stacked(
                    {{0.9, 0.6, 0}, {0.9, 0.6, 0.2}, {0.3 + top, top, 0.2 + height}}, diagonals);
                EXPECT_EQ(edges_of(mesh, creases_of(mesh)).size(), 20u)
                    << top << ' ' << height << ' ' << diagonals;
            }
}

/// Of a fillet, tangent at both ends, neither its ends nor its facets; of an eighth of a circle,
/// which meets its neighbours at angles, its ends.
TEST(Creases, AreTheEndsOfArcsThatAreNotTangent) {
    for (const int facets : {3, 4, 6, 12}) {
        std::vector<Eigen::Vector2d> fillet{{-2, -2}, {1, -2}}, bulge = fillet;
        for (int i = 0; i <= facets; ++i) {
            const double angle = kTurn / 4 * i / facets, low = angle / 2 + kTurn / 16;
            fillet.push_back({std::cos(angle), std::sin(angle)});
            bulge.push_back({0.3 + std::cos(low), std::sin(low)});
        }
        for (auto* section : {&fillet, &bulge})
            section->push_back({-2, section->back().y()});
        const TriangleMesh round = prism(fillet), blunt = prism(bulge);
        EXPECT_EQ(edges_along(round, creases_of(round)), 3u) << facets;
        EXPECT_EQ(edges_along(blunt, creases_of(blunt)), 5u) << facets;
    }
}

/// A plate with a block in its middle, a concave fillet around it and a convex one around its top.
TriangleMesh filleted_block(int facets, double top_radius, unsigned diagonals) {
    std::vector<Eigen::Vector3d> rings{{4, 3, -1}, {4, 3, 0}};
    for (int i = 0; i <= facets; ++i) {
        const double angle = kTurn / 4 * i / facets, out = 1 - std::sin(angle);
        rings.push_back({2 + out, 1.2 + out, 1 - std::cos(angle)});
    }
    for (int i = 0; i <= (top_radius > 0 ? facets : 0); ++i) {
        const double angle = kTurn / 4 * i / facets, in = top_radius * (1 - std::cos(angle));
        rings.push_back({2 - in, 1.2 - in, 3 + top_radius * std::sin(angle)});
    }
    return test_meshes::stacked(rings, diagonals);
}

/// Where fillets around a block meet, an edge runs from the block's corner out into the plate, ever
/// lower, and ends there.
TEST(Creases, RunOutAlongTheMitresOfFillets) {
    for (const int facets : {3, 4, 6})
        for (const unsigned diagonals : {0u, ~0u, 0x55555555u}) {
            const TriangleMesh mesh = filleted_block(facets, 0, diagonals);
            EXPECT_EQ(edges_of(mesh, creases_of(mesh)).size(), std::size_t(20 + 4 * facets))
                << facets << ' ' << diagonals;
        }
}

/// They are not led on along the fillets' facets, although these meet the mitre at its end.
TEST(Creases, DoNotRunOutAlongFacets) {
    for (const int facets : {4, 6, 10, 12, 16}) {
        const TriangleMesh mesh = filleted_block(facets, 0.6, 0);
        const std::multiset<Edge> edges = edges_of(mesh, creases_of(mesh));
        EXPECT_GE(edges.size(), 12u) << "those of the plate";
        for (const auto& [a, b] : edges) {
            const Eigen::Vector3d edge_vector = mesh.positions[a] - mesh.positions[b];
            const double z = std::min(mesh.positions[a].z(), mesh.positions[b].z());
            EXPECT_TRUE(z <= 0 || std::abs(edge_vector.z()) > 0) << facets << ' ' << z;
        }
    }
}

TEST(Creases, AreTheRimsOfHolesInPlates) {
    for (const std::uint32_t sides : {6u, 12u, 24u, 100u}) {
        const TriangleMesh mesh = plate_with_hole(sides);
        EXPECT_EQ(edges_on_rings(mesh, creases_of(mesh)), 2 * sides + 8) << sides;
    }
}

TEST(Creases, AreTheRimsOfSmallHoles) {
    for (const double radius : {0.3, 0.03, 0.003}) {
        const TriangleMesh mesh = turned(36, {{1, -0.3}, {1, 0.3}, {radius, 0.3}, {radius, 0.2}});
        EXPECT_EQ(edges_of(mesh, creases_of(mesh)).size(), 4 * 36u) << radius;
    }
}

/// Steps as high as a voxel are flat and sharp as made parts are.
TEST(Creases, AreNotTheStepsOfSegmentedVolumes) {
    EXPECT_TRUE(creases_of(test_meshes::terraced_head(60)).lines.empty());
}

/// A bent tube of strips, of which hardly any are flat faces of several triangles.
TEST(Creases, AreTheEndsOfNarrowTriangles) {
    constexpr std::uint32_t sides = 150;
    std::vector<Ring> rings;
    for (const auto& [radius, aside] :
         std::vector<std::pair<double, double>>{{1, 0}, {1.2, 0.3}, {1.1, 0.2}, {0.7, -0.4}}) {
        const auto number = double(rings.size());
        rings.push_back(circle(sides, radius, 3 * number, kTurn / (2 * sides) * number));
        for (Eigen::Vector3d& p : rings.back())
            p = Eigen::Vector3d(p.x() + aside, 0.8 * p.y(), p.z());
    }
    const TriangleMesh tube = joined(rings);
    EXPECT_EQ(refined(tube).triangles.size(), tube.triangles.size());
    double length = 0;
    for (std::uint32_t i = 0; i < sides; ++i)
        for (const Ring& ring : {rings.front(), rings.back()})
            length += (ring[(i + 1) % sides] - ring[i]).norm();
    length /= precompute(tube).scale.diagonal;
    EXPECT_NEAR(helpers::total_length(creases_of(tube)), length, 0.01 * length);
}

/// A vertex of a scan that sticks out.
TEST(Creases, AreNoFewEdgesOfAScanWithLooseEnds) {
    TriangleMesh scan = test_meshes::bumpy_sphere(3).mesh;
    scan.positions[100] *= 1.15;
    EXPECT_EQ(creases_of(scan).lines.size(), 0u);
}

TEST(Creases, AreHardlyAnyOnNoisyScans) {
    const TriangleMesh mesh = test_meshes::bumpy_sphere(6).mesh;  // 81,920 triangles
    EXPECT_EQ(helpers::total_length(creases_of(mesh)), 0);
    for (const double noise : {0.2, 0.4}) {
        const TriangleMesh noisy = test_meshes::with_noise(mesh, noise);
        EXPECT_LT(helpers::total_length(creases_of(noisy)), noise < 0.3 ? 0.05 : 2) << noise;
    }
}

/// Its faces then are flat and of several triangles, as those of CAD meshes are.
TEST(Creases, AreHardlyAnyOnScansThatWereSubdivided) {
    for (const double noise : {0.06, 0.1}) {
        const TriangleMesh scan = test_meshes::with_noise(test_meshes::bumpy_sphere(5).mesh, noise);
        for (const int times : {1, 2}) {
            const TriangleMesh cut = test_meshes::subdivided(scan, times);
            EXPECT_LT(helpers::total_length(creases_of(cut)), 0.05) << noise;
        }
    }
}

/// Of a part whose fillets are a few triangles wide, where edges sharper than the least angle
/// are isolated, in zigzags and in loops.
TEST(Creases, AreLeftToRidgesOnFilletsOfFewTriangles) {
    const auto drawn = [&](const TriangleMesh& mesh, std::initializer_list<LineKind> kinds) {
        LineStyle style = helpers::only(LineKind::Crease);
        style.shows = only_kinds(kinds);
        std::map<LineKind, double> lengths;
        const LineSet lines = creases_of(mesh, style);
        for (const Polyline& line : lines.lines)
            for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
                lengths[line.kind] +=
                    double(lines.points[i].opacity) *
                    double((lines.points[i].position - lines.points[i - 1].position).norm());
        return lengths;
    };
    for (const auto& [radius, cells] : {std::pair(0.04, 60), {0.05, 80}, {0.06, 40}}) {
        const TriangleMesh mesh =
            test_meshes::with_noise(test_meshes::rounded_cube(cells, radius), 0.02);
        auto alone = drawn(mesh, {LineKind::Ridge}),
             both = drawn(mesh, {LineKind::Ridge, LineKind::Crease});
        EXPECT_GT(alone[LineKind::Ridge], 10) << radius;
        EXPECT_GT(both[LineKind::Ridge], 0.9 * alone[LineKind::Ridge]) << radius;
        EXPECT_LT(both[LineKind::Crease], 0.1 * alone[LineKind::Ridge]) << radius;
    }
}

/// Of triangular faces, too, such as those of studs.
TEST(Creases, AreTheEdgesOfSmallForms) {
    TriangleMesh octahedron;
    octahedron.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    octahedron.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                            {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (const auto& [small, edges] :
         {std::pair(octahedron, 12u), {turned(6, {{1, -1}, {1, 1}}), 18u}}) {
        const TriangleMesh mesh = together(test_meshes::cube(1), moved(small, {3, 0, 0}, 0.03));
        EXPECT_EQ(edges_of(mesh, creases_of(mesh)).size(), 12 + edges);
    }
}

/// An edge between a visible face and a hidden one is a contour there.
TEST(Creases, AreLeftOutOnTheHorizon) {
    for (const int cells : {1, 10})
        for (const Eigen::Vector3d& eye :
             {Eigen::Vector3d(3, 2, 4), Eigen::Vector3d(3, 0.5, 0.5)}) {
            const TriangleMesh mesh = test_meshes::cube(cells);
            LineStyle style = helpers::only(LineKind::Crease);
            style.shows[LineKind::Contour] = true;
            LineSet lines = creases_of(mesh, style, View::perspective(eye));
            LineSet creases;
            creases.points = lines.points;
            for (const Polyline& line : lines.lines)
                if (line.kind == LineKind::Crease) creases.lines.push_back(line);
            const unsigned count = eye.y() > 1 ? 6 : 8;  // where three faces are seen, or one
            EXPECT_EQ(creases.lines.size(), count);
            const auto edges = edges_of(mesh, creases);
            EXPECT_EQ(edges.size(), count * unsigned(cells));
            for (const Edge& edge : edges) {
                const Eigen::Vector3d middle =
                    (mesh.positions[edge.first] + mesh.positions[edge.second]) / 2;
                int seen = 0;
                for (int k = 0; k < 3; ++k)
                    seen += std::abs(std::abs(middle[k]) - 1) < 1e-9 && middle[k] * eye[k] > 1;
                EXPECT_NE(seen, 1);  // between two that are seen, or two that are not
            }
        }
}

/// Closed, but without an inside: every other face of an octahedron, and its three squares.
TEST(Creases, DoNotFaceAwayOnSurfacesThatCannotBeOriented) {
    TriangleMesh mesh{{}, {{0, 1, 2}}};
    for (std::uint32_t k = 0; k < 6; ++k)
        mesh.positions.push_back((k < 3 ? 1 : -1) * Eigen::Vector3d::Unit(k % 3));
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t next = (k + 1) % 3, last = (k + 2) % 3;
        mesh.triangles.push_back({k, next + 3, last + 3});
        mesh.triangles.push_back({k, next, k + 3});
        mesh.triangles.push_back({k, k + 3, next + 3});
    }
    EXPECT_EQ(edges_of(mesh, creases_of(mesh)).size(), 12u);
    LineStyle style = helpers::only(LineKind::Crease);
    style.shows[LineKind::Contour] = true;
    std::size_t creases = 0;
    for (const View& view : helpers::random_views(mesh, 8))
        for (const Polyline& line : creases_of(mesh, style, view).lines) {
            creases += line.kind == LineKind::Crease;
            EXPECT_GE(line.slope, 0);
        }
    EXPECT_GT(creases, 0u);
}

/// Of a closed line, what is left are whole arcs.
TEST(Creases, AreCutWhereTheHorizonBegins) {
    const std::uint32_t sides = 48;
    const TriangleMesh mesh = turned(sides, {{0.5, -1}, {0.5, 1}});
    LineStyle style = helpers::only(LineKind::Crease);
    style.shows[LineKind::Contour] = true;
    // From above: the lid is seen, and the near part of the wall.
    const LineSet lines = creases_of(mesh, style, View::perspective({4, 0.1, 6}));
    std::size_t arcs = 0, edges = 0;
    for (const Polyline& line : lines.lines) {
        if (line.kind != LineKind::Crease) continue;
        ++arcs;
        edges += line.count - 1;
        EXPECT_FALSE(line.closed);
        float length = 0;
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
            length += (lines.points[i].position - lines.points[i - 1].position).norm();
        EXPECT_NEAR(line.length * std::sqrt(6.), length, 1e-4);  // D
    }
    EXPECT_EQ(arcs, 2u);
    EXPECT_EQ(edges, sides);  // each side of the wall is in one of the two
}

/// Flat faces have no form of their own, only errors.
TEST(Creases, LeaveNoLaplacianLinesOnFacesBesideThem) {
    const auto count = [](const TriangleMesh& mesh, bool has_creases) {
        LineStyle style = helpers::all_laplacian_lines();
        style.shows[LineKind::Crease] = has_creases;
        const LineExtractor extractor(mesh, precompute(mesh));
        std::size_t lines = 0;
        for (const View& view : helpers::random_views(mesh, 6))
            for (const Polyline& line : helpers::extract(extractor, view, style).lines)
                lines += line.kind == LineKind::Laplacian;
        return lines;
    };
    for (const TriangleMesh& mesh : {test_meshes::cube(1), test_meshes::cube(10)})
        EXPECT_EQ(count(mesh, true), 0u);
    const TriangleMesh small_hole = turned(36, {{1, -0.3}, {1, 0.3}, {0.02, 0.3}, {0.02, 0.2}});
    EXPECT_GT(count(small_hole, false), 0u);
    EXPECT_EQ(count(small_hole, true), 0u);
    const TriangleMesh facets = turned(24, {{0.3, -1},
                                            {0.6, -0.7},
                                            {0.7, -0.4},
                                            {0.65, -0.1},
                                            {0.45, 0.2},
                                            {0.35, 0.4},
                                            {0.4, 0.6},
                                            {0.5, 0.75}});
    EXPECT_GT(4 * count(facets, true), 3 * count(facets, false)) << "of a curved surface";
}

/// The rim of a dish, which bends inwards and outwards by turns.
TEST(Creases, EncloseNoRidges) {
    std::vector<Ring> rings;
    for (const auto& [radius, z] : {std::pair(1., -0.3), {1., 0.3}, {0.9, 0.3}, {0.9, 0.27}}) {
        Ring& ring = rings.emplace_back(circle(36, radius, z));
        for (Eigen::Vector3d& p : ring)
            p.head<2>() *= 1 + 0.1 * std::cos(5 * std::atan2(p.y(), p.x()));
    }
    LineStyle style = helpers::only(LineKind::Crease);
    style.shows[LineKind::Ridge] = style.shows[LineKind::Valley] = true;
    style.ridge_angle = 5;
    const LineSet lines = creases_of(joined(rings), style);
    EXPECT_FALSE(lines.lines.empty());
    for (const Polyline& line : lines.lines)
        EXPECT_EQ(line.kind, LineKind::Crease);
}

}  // namespace
