// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of lines are seen, on surfaces whose outlines are known.
#include "laplacian_lines/line_visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace {

using namespace laplacian_lines;
using Eigen::Vector3d;
using helpers::length_of;
using helpers::total_length;
using test_meshes::moved;
using test_meshes::together;

const double kPi = std::acos(-1.0);
const View kAslant = View::orthographic({0.45, -0.68, -0.35});

struct Scene {
    TriangleMesh mesh;
    Field field = precompute(mesh);
    LineExtractor extractor{mesh, field};
    LineVisibility visibility{mesh};

    LineSet on_surface(const View& view, const LineStyle& style) const {
        ExtractionScratch scratch;
        return extract_on_surface(extractor, view, style, scratch);
    }

    LineParts parts(const View& view, const LineStyle& style, double smoothing = 0) const {
        return visibility.parts(view, {on_surface(view, style)}, {style.shows, smoothing, true});
    }
};

/// Unit spheres: at the origin, seen from +z, and well behind it, a radius to the right.
TriangleMesh two_balls() {
    const TriangleMesh ball = test_meshes::sphere(5).mesh;
    return together(ball, moved(ball, {1, 0, -4}));
}

LineParts contours_of(const TriangleMesh& mesh, const View& view) {
    return LineVisibility(mesh).parts(view, {}, {helpers::all_contours().shows, 1.2, true});
}

/// Two halves, between which coordinates are off by what floats have there.
TriangleMesh far_ball(bool has_crack) {
    const TriangleMesh ball = moved(test_meshes::sphere(4).mesh, {17000, 17000, 17000}, 5);
    TriangleMesh halves = test_meshes::rounded_to_floats(ball);
    const std::vector<Vector3d> again = halves.positions;
    halves.positions.insert(halves.positions.end(), again.begin(), again.end());
    const auto count = std::uint32_t(again.size());
    for (Triangle& t : halves.triangles) {
        const Vector3d centre =
            (ball.positions[t[0]] + ball.positions[t[1]] + ball.positions[t[2]]) / 3;
        if (centre.x() > 17000)
            for (std::uint32_t& v : t)
                v += count;
    }
    for (std::uint32_t v = count; has_crack && v < 2 * count; ++v)
        halves.positions[v].y() += (int(v % 3) - 1) * 0x1p-9;  // a unit in the last place
    return halves;
}

TEST(LineVisibility, HasNoContoursAlongCracksOfRounding) {
    const auto length = [](bool has_crack) {
        return length_of(LineVisibility(far_ball(has_crack))
                             .visible_lines(kAslant, {}, {helpers::all_contours().shows}));
    };
    EXPECT_GT(length(false), 9 * kPi);
    EXPECT_NEAR(length(true), length(false), 0.01 * length(false));
}

/// A pyramid whose tip is a triangle smaller than the precision.
TEST(LineVisibility, HasNoBordersWhereTrianglesHaveNoHeight) {
    const TriangleMesh pyramid = {
        {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, -1e-8, 1}, {1e-8, 0, 1}, {-1e-8, 0, 1}},
        {{0, 2, 1}, {0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}, {3, 4, 5}}};
    auto shows = helpers::all_contours().shows;
    shows[LineKind::Border] = true;
    const auto lines =
        LineVisibility(pyramid).visible_lines(View::orthographic({0, 0, 1}), {}, {shows});
    EXPECT_FALSE(lines.empty());
    for (const ViewLine& line : lines)
        EXPECT_NE(line.kind, LineKind::Border);
}

/// A fan of triangles that are lower than the precision, along an edge that is hardly bent.
TEST(LineVisibility, HasNoSlitsWhereTrianglesHaveNoHeight) {
    const auto length = [](const std::vector<Eigen::Vector2d>& corners) {
        auto shows = helpers::all_contours().shows;
        shows[LineKind::Border] = true;
        return length_of(
            LineVisibility(test_meshes::prism(corners)).visible_lines(kAslant, {}, {shows, 0}));
    };
    std::vector<Eigen::Vector2d> square = {{0, 1}, {0, 0}, {1, 0}, {1, 1}}, bent = square;
    for (int i = 1; i < 8; ++i)
        bent.push_back({1 - 0.05 * i, 1 + 3e-8 * i * (12 - i)});
    EXPECT_NEAR(length(square), 6, 1e-3);
    EXPECT_NEAR(length(bent), length(square), 1e-3);
}

/// Whichever of its walls the turned eye sees.
TEST(LineVisibility, HasContoursAllAroundAStepSeenFromAbove) {
    const Scene scene{
        test_meshes::stacked({{1, 1, 0}, {1, 1, 0.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, 1}})};
    const View view = View::orthographic(Vector3d::UnitZ());
    const auto lines =
        scene.visibility.visible_lines(view, {scene.on_surface(view, LineStyle())}, {});
    const auto is_on_top = [](const ViewLine& line, const Vector3d& p) {
        return line.kind == LineKind::Contour && p.z() > 0.99;
    };
    EXPECT_NEAR(length_of(lines, is_on_top), 4, 1e-3);
}

bool is_in_front(const LineSet& lines, const Polyline& line) {
    return lines.points[line.first].position.z() > -2;
}

/// 120 degrees of the far outline are within the near one.
TEST(LineVisibility, NearBallHidesAThirdOfTheFarOnesOutline) {
    const LineParts parts = contours_of(two_balls(), View::orthographic(Vector3d::UnitZ()));
    ASSERT_EQ(parts.seen.lines.size(), 2u);
    ASSERT_EQ(parts.hidden.lines.size(), 1u);
    const double d = Vector3d(3, 2, 6).norm();
    for (const Polyline& line : parts.seen.lines) {
        const double length = double(line.length) * d;
        EXPECT_EQ(line.closed, is_in_front(parts.seen, line));
        EXPECT_NEAR(length, line.closed ? 2 * kPi : 4 * kPi / 3, 0.06);
        if (line.closed) continue;
        for (const LinePoint& end :
             {parts.seen.points[line.first], parts.seen.points[line.first + line.count - 1]}) {
            EXPECT_NEAR(end.position.x(), 0.5, 0.02);
            EXPECT_NEAR(std::abs(end.position.y()), std::sqrt(0.75), 0.02);
        }
    }
    EXPECT_NEAR(double(parts.hidden.lines[0].length) * d, 2 * kPi / 3, 0.03);
}

/// Unhidden lines stay as they are, closed ones closed.
TEST(LineVisibility, KeepsWhatNothingHides) {
    const Scene scene{test_meshes::hills(40).mesh};
    const View view = View::orthographic(Vector3d::UnitZ());
    const LineSet all = scene.on_surface(view, helpers::all_laplacian_lines());
    ASSERT_GT(all.lines.size(), 3u);
    EXPECT_TRUE(std::any_of(all.lines.begin(), all.lines.end(), [](auto& p) { return p.closed; }));
    const LineSet seen = scene.parts(view, helpers::all_laplacian_lines()).seen;
    ASSERT_EQ(seen.lines.size(), all.lines.size());
    for (std::size_t i = 0; i < all.lines.size(); ++i) {
        EXPECT_EQ(seen.lines[i].count, all.lines[i].count);
        EXPECT_EQ(seen.lines[i].closed, all.lines[i].closed);
        EXPECT_EQ(seen.lines[i].kind, all.lines[i].kind);
        EXPECT_EQ(seen.lines[i].strength, all.lines[i].strength);
        const std::uint32_t first = seen.lines[i].first, last = first + seen.lines[i].count - 1;
        EXPECT_TRUE(!seen.lines[i].closed ||
                    seen.points[first].position == seen.points[last].position);
    }
    ASSERT_EQ(seen.points.size(), all.points.size());
    for (std::size_t i = 0; i < all.points.size(); ++i)
        EXPECT_LT((seen.points[i].position - all.points[i].position).norm(), 1e-6f);
}

// --- against a torus that is known exactly, not by triangles

constexpr test_meshes::Torus kTorus;

/// Whether the ray from p to the eye gets this deep into the solid torus, by marching.
bool torus_hides(const Vector3d& p, const View& view, double clearance, double depth) {
    const Vector3d to_eye = view.eye - view.w * p;
    const double step = 2e-3, reach = view.w == 0 ? 12 : std::min(12.0, to_eye.norm());
    for (double t = clearance; t < reach; t += step) {
        const Vector3d q = p + t * to_eye.normalized();
        const double ring = std::hypot(q.x(), q.y()) - kTorus.large;
        if (std::hypot(ring, q.z()) < kTorus.small - depth) return true;
    }
    return false;
}

/// Points of lines are seen where it surely does not hide them, hidden where it surely does.
TEST(LineVisibility, AgreesWithTheExactTorus) {
    const Scene scene{test_meshes::torus(160, 80).mesh};
    const double d = scene.field.scale.diagonal;
    const LineStyle style = helpers::all_laplacian_lines();
    for (const View& view : {View::orthographic({0.2, -1, 0.6}), View::perspective({0.5, -3, 1.5}),
                             View::perspective({3, 0.3, 0.1})}) {
        const LineSet seen = scene.parts(view, style).seen;
        int sure = 0, hidden = 0, wrong = 0;
        for (const LinePoint& point : scene.on_surface(view, style).points) {
            const Vector3d p = point.position.cast<double>();
            const bool is_hidden = torus_hides(p, view, 0.02, 0.003 * d);
            if (is_hidden != torus_hides(p, view, 0.001, 1e-4)) continue;  // at the horizon
            ++sure;
            hidden += is_hidden;
            wrong += is_hidden == (helpers::distance_to_lines(p, seen) < 1e-6 * d);
        }
        EXPECT_GT(hidden, sure / 10);
        EXPECT_LT(hidden, sure * 9 / 10);
        EXPECT_LE(wrong, sure / 80) << "of " << sure;
    }
}

/// Beyond a cusp a contour is behind its own form, however thin the fold.
TEST(LineVisibility, ContoursEndAtCusps) {
    const LineSet seen = contours_of(test_meshes::torus(288, 144).mesh, kAslant).seen;
    const Vector3d v = kAslant.eye.normalized();
    int wrong = 0;
    for (const LinePoint& point : seen.points) {
        const Vector3d p = point.position.cast<double>();
        const double ring = std::hypot(p.x(), p.y()) - 1;
        const auto truth = test_meshes::closed_form_torus_point({}, std::atan2(p.y(), p.x()),
                                                                std::atan2(p.z(), ring));
        wrong += v.dot(truth.shape_operator * v) < -0.1;
    }
    EXPECT_GT(seen.points.size(), 500u);
    EXPECT_LE(wrong, 20);  // contours of triangles zigzag there
}

// --- lines of few points

/// Two triangles, a × b, facing +z.
void add_rectangle(TriangleMesh& mesh, const Vector3d& centre, double a, double b) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const auto& corner :
         {Vector3d(-a, -b, 0), Vector3d(a, -b, 0), Vector3d(a, b, 0), Vector3d(-a, b, 0)})
        mesh.positions.push_back(centre + corner / 2);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

/// A bar across the middle of a segment whose ends are seen.
TEST(LineVisibility, HidesTheMiddleOfALongSegment) {
    TriangleMesh mesh;
    add_rectangle(mesh, {0, 0, 0}, 4, 1);
    add_rectangle(mesh, {0, 0, 1}, 0.5, 3);
    const LineVisibility visibility(mesh);
    LineSet line;
    line.points = {{{-1.5f, 0.25f, 0}, 0, 10, 1}, {{1.5f, 0.25f, 0}, 1, 20, 1}};
    line.lines = {{0, 2, LineKind::Ridge, false, 7, 0.6f, 5}};
    const auto seen_from = [&](const View& view) {
        return visibility.parts(view, {line}, {LineKindSet(), 1.2}).seen;
    };
    const LineSet seen = seen_from(View::orthographic(Vector3d::UnitZ()));
    ASSERT_EQ(seen.lines.size(), 2u);
    ASSERT_EQ(seen.points.size(), 4u);
    const double d = Vector3d(4, 3, 1).norm();
    EXPECT_NEAR(seen.points[1].position.x(), -0.25, 1e-4 * d);
    EXPECT_NEAR(seen.points[2].position.x(), 0.25, 1e-4 * d);
    EXPECT_NEAR(seen.points[2].weight, 1.75 / 3, 1e-3);
    EXPECT_NEAR(seen.points[1].gradient, 10 + 10 * 1.25 / 3, 1e-2);
    for (const Polyline& part : seen.lines) {
        EXPECT_EQ(part.kind, LineKind::Ridge);
        EXPECT_EQ(part.strength, 7);
        EXPECT_EQ(part.slope, 5);
        EXPECT_NEAR(part.length * d, 1.25, 1e-3 * d);
    }
    // From the other side nothing is before it but the rectangle it lies in.
    EXPECT_EQ(seen_from(View::orthographic({0, 0.01, -1})).lines.size(), 1u);
    const LineSet from_near = seen_from(View::perspective({0, 0.25, 1.5}));
    ASSERT_EQ(from_near.lines.size(), 2u);
    EXPECT_NEAR(from_near.points[1].position.x(), -0.75, 1e-4 * d);
}

TEST(LineVisibility, FarFromTheOriginAndFarFromTheEye) {
    const Vector3d offset(4096.1, -2048.2, 8192.3);
    const LineParts balls =
        contours_of(moved(two_balls(), offset), View::perspective(offset + Vector3d(0, 0, 50)));
    EXPECT_EQ(balls.seen.lines.size(), 2u);
    EXPECT_EQ(balls.hidden.lines.size(), 1u);
    const Scene near{test_meshes::torus(160, 80).mesh}, far{moved(near.mesh, offset)};
    const LineStyle style = helpers::all_laplacian_lines();
    const float length = total_length(near.parts(kAslant, style).seen);
    EXPECT_GT(length, 0);
    EXPECT_NEAR(total_length(far.parts(kAslant, style).seen), length, 0.07f * length);
    for (const double distance : {1e7, 1e12, 1e20})
        EXPECT_NEAR(total_length(near.parts({kAslant.eye, 1 / distance}, style).seen), length,
                    1e-3);
}

TEST(LineVisibility, TellsInsideFromOutside) {
    const LineVisibility visibility(two_balls());
    EXPECT_TRUE(visibility.encloses({0, 0, 0}));
    EXPECT_TRUE(visibility.encloses({1.9, 0, -4}));
    EXPECT_FALSE(visibility.encloses({0, 0, 1.1}));
    EXPECT_FALSE(visibility.encloses({0.5, 0, -2}));
    EXPECT_TRUE(LineVisibility(test_meshes::flipped(two_balls(), 3)).encloses({0, 0, 0}));
}

// --- what does not change it

TEST(LineVisibility, DoesNotDependOnWhichSideTrianglesFace) {
    TriangleMesh mesh = test_meshes::torus(144, 72).mesh;
    const LineParts outside = contours_of(mesh, kAslant);
    ASSERT_FALSE(outside.seen.lines.empty() || outside.hidden.lines.empty());
    for (const int every : {1, 3}) {
        mesh = test_meshes::flipped(mesh, every);
        const LineParts flipped = contours_of(mesh, kAslant);
        EXPECT_NEAR(total_length(flipped.seen), total_length(outside.seen), 1e-4f);
        EXPECT_NEAR(total_length(flipped.hidden), total_length(outside.hidden), 1e-4f);
    }
}

/// A Laplacian line around the origin.
LineSet ring(double radius, std::uint32_t points) {
    LineSet lines;
    const test_meshes::Ring circle = test_meshes::circle(points, radius, 0, 1);
    for (std::uint32_t i = 0; i <= points; ++i)
        lines.points.push_back({circle[i % points].cast<float>(), 1, 0, 1});
    Polyline line;
    line.count = points + 1;
    line.kind = LineKind::Laplacian;
    line.closed = true;
    line.length = float(2 * kPi * radius / std::sqrt(12.0));
    lines.lines = {line};
    return lines;
}

LineSet seen_ring(const LineSet& ring, const View& view,
                  const TriangleMesh& mesh = test_meshes::sphere(3).mesh) {
    return LineVisibility(mesh)
        .parts(view, {ring}, {helpers::all_laplacian_lines().shows, 0, true})
        .seen;
}

/// Within a sphere, a small ball six of its radii before the eye.
TEST(LineVisibility, WhatIsBeforeAnEyeAmongTheMeshHidesWhatIsBehind) {
    constexpr double kRadius = 0.99, kEye = -0.2;
    const TriangleMesh mesh = together(test_meshes::sphere(3).mesh,
                                       moved(test_meshes::sphere(4).mesh, {kEye + 0.6, 0, 0}, 0.1));
    const LineSet all = ring(kRadius, 80);
    const View view = View::perspective({kEye, 0, 0});
    const float hidden =
        total_length(seen_ring(all, view)) - total_length(seen_ring(all, view, mesh));
    const double from_eye = std::asin(0.1 / 0.6),
                 angle = from_eye - std::asin(kEye * std::sin(from_eye) / kRadius);
    EXPECT_NEAR(hidden / total_length(all), angle / kPi, 0.002);
}

/// Eyes are turned about an axis across their direction from the centre; there they have none.
TEST(LineVisibility, AnEyeAtTheCentreSeesToBothSides) {
    TriangleMesh mesh;
    for (const double z : {-1., 1.})
        add_rectangle(mesh, {0, 0, z}, 2, 2);
    const auto seen = [&] {
        const LineParts parts = LineVisibility(mesh).parts(View::perspective({0, 0, 0}), {}, {});
        return total_length(parts.seen);
    };
    EXPECT_NEAR(seen(), 16 / std::sqrt(12), 5e-4);
    const auto plates = std::uint32_t(mesh.positions.size());  // and walls seen edge-on
    for (const double side : {-1., 1.})
        add_rectangle(mesh, {side * 0.7, 0, 0}, 0.4, 1);
    for (std::uint32_t i = plates; i < mesh.positions.size(); ++i)
        std::swap(mesh.positions[i].y(), mesh.positions[i].z());
    EXPECT_NEAR(seen(), 21.6 / std::sqrt(12), 1e-3);
}

/// From behind, half a torus shows its inside, with all contours: its highest and lowest points.
TEST(LineVisibility, ContoursOfOpenSurfacesAreSeenFromInside) {
    const LineParts parts = contours_of(test_meshes::half_torus(144, 72).mesh,
                                        View::orthographic({0, -1, 0}));  // into the open ends
    EXPECT_TRUE(parts.hidden.lines.empty());
    EXPECT_NEAR(total_length(parts.seen), 2 * kPi / Vector3d(2.8, 1.4, 0.8).norm(), 0.01);
}

/// Edges between front and back, in D.
float contour_edge_length(const TriangleMesh& mesh, const View& view, double d) {
    double length = 0;
    for (const auto& [a, b] : helpers::horizon_of(mesh, view))
        length += (mesh.positions[a] - mesh.positions[b]).norm();
    return float(length / d);
}

TriangleMesh block_on_plate() {
    return test_meshes::stacked({{4, 3, -1}, {4, 3, 0}, {2, 1, 0}, {2, 1, 3}});
}

double length_from_above(const LineSet& lines) {
    double length = 0;
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first; i + 1 < line.first + line.count; ++i)
            length +=
                double((lines.points[i + 1].position - lines.points[i].position).head<2>().norm());
    return length;
}

/// However the eye misses the walls' planes, and where specks touch the walls' edges.
TEST(LineVisibility, WallsSeenAlongTheirPlanesHaveContours) {
    TriangleMesh touched = block_on_plate();
    constexpr double kSpeck = 1e-4;
    for (const double side : {-1., 1.})
        touched = together(
            touched, moved(test_meshes::cube(1), {0.3, side * (1 + kSpeck), 3 + kSpeck}, kSpeck));
    for (const TriangleMesh& mesh : {block_on_plate(), touched})
        for (const double aside : {0., 1e-6, -1e-6}) {
            const View view = View::orthographic({aside, 2 * aside, 1});
            const LineParts parts =
                LineVisibility(mesh).parts(view, {}, {helpers::all_contours().shows, 0, true});
            EXPECT_NEAR(length_from_above(parts.seen), 28 + 12, 0.01) << aside;
        }
}

/// Along as much of the one wall as of the other.
TEST(LineVisibility, WallsBetweenFilletsHaveContoursOnBothSides) {
    std::vector<Vector3d> rings = {{8, 6, -1}, {8, 6, 0}};
    for (int i = 0; i <= 8; ++i) {
        const double angle = kPi / 2 * i / 8, in = 1 - std::sin(angle), up = 1 - std::cos(angle);
        rings.push_back({3 + in, 2 + in, up});
    }
    for (int i = 0; i <= 8; ++i) {
        const double angle = kPi / 2 * i / 8, in = 1 - std::cos(angle);
        rings.push_back({3 - in, 2 - in, 4 + std::sin(angle)});
    }
    const TriangleMesh mesh = test_meshes::stacked(rings);
    for (const double aside : {0., 1e-6, -1e-6}) {
        const LineParts parts = LineVisibility(mesh).parts(
            View::orthographic({1, aside, 1}), {}, {helpers::all_contours().shows, 0, true});
        std::array<std::array<bool, 100>, 2> is_there{};  // along the walls in the picture
        for (const Polyline& line : parts.seen.lines)
            for (std::uint32_t i = line.first; i + 1 < line.first + line.count; ++i) {
                const Eigen::Vector3f &a = parts.seen.points[i].position,
                                      &b = parts.seen.points[i + 1].position;
                if (std::abs(std::abs(a.y()) - 2) > 1e-3 || std::abs(a.y() - b.y()) > 1e-3)
                    continue;
                const auto [low, high] = std::minmax({a.z() - a.x(), b.z() - b.x()});
                for (int k = 0; k < 100; ++k)
                    is_there[a.y() > 0][std::size_t(k)] |=
                        low < 0.1f * float(k - 40) + 0.05f && 0.1f * float(k - 40) + 0.05f < high;
            }
        const auto count = std::count(is_there[0].begin(), is_there[0].end(), true);
        EXPECT_GT(count, 60) << aside;
        EXPECT_EQ(is_there[0], is_there[1]) << aside;
    }
}

TEST(LineVisibility, SeenAndHiddenContoursAreAllThereAre) {
    const Scene scene{test_meshes::bumpy_sphere(5).mesh};
    for (const View& view : {kAslant, View::perspective({2, 1, -3})}) {
        const LineParts parts = scene.parts(view, helpers::all_contours());
        const float whole = contour_edge_length(scene.mesh, view, scene.field.scale.diagonal);
        EXPECT_GT(total_length(parts.hidden), 0.05f * whole);
        EXPECT_NEAR(total_length(parts.seen) + total_length(parts.hidden), whole, 0.02f * whole);
    }
}

/// A unit ball from +z, with a small one before its middle or its outline.
float length_with_small_ball(double radius, double x, double shortest_contour) {
    const TriangleMesh ball = test_meshes::sphere(4).mesh;
    const VisibilityOptions options{helpers::all_contours().shows, 0, false, false,
                                    shortest_contour};
    const auto view = View::orthographic({0, 0, 1});
    const LineVisibility visibility(together(ball, moved(ball, {x, 0, 2}, radius)));
    return total_length(visibility.parts(view, {}, options).seen);
}

TEST(LineVisibility, SpecksAreLeftOutWhereNothingMeetsThem) {
    constexpr double small = 0.002, large = 0.05;
    const float whole = length_with_small_ball(small, 0, 0);
    EXPECT_LT(length_with_small_ball(small, 0, 0.005), whole);
    EXPECT_GT(length_with_small_ball(small, 0, 0.005), 0.99f * whole);
    EXPECT_EQ(length_with_small_ball(large, 0, 0.005), length_with_small_ball(large, 0, 0));
    EXPECT_EQ(length_with_small_ball(small, 1, 0.005), length_with_small_ball(small, 1, 0));
}

/// The last look's creases are kept.
TEST(LineVisibility, DrawsTheCreasesOfEachLook) {
    const Scene scene{test_meshes::cube(3)};
    const LineStyle style = helpers::only(LineKind::Crease);
    const LineSet creases = scene.on_surface(kAslant, style);
    ASSERT_GT(creases.lines.size(), 1u);
    LineSet fewer = creases;
    fewer.lines.resize(1);
    std::vector<float> lengths;
    for (const LineSet& lines : {creases, fewer, creases}) {
        const VisibilityOptions options{style.shows, 0, true};
        const LineParts kept = scene.visibility.parts(kAslant, {lines}, options),
                        anew = LineVisibility(scene.mesh).parts(kAslant, {lines}, options);
        EXPECT_TRUE(helpers::same_lines(kept.seen, anew.seen));
        EXPECT_TRUE(helpers::same_lines(kept.hidden, anew.hidden));
        lengths.push_back(total_length(kept.seen));
    }
    EXPECT_GT(lengths[0], lengths[1]);
    EXPECT_EQ(lengths[0], lengths[2]);
}

/// Of a tower of 1 x 1 x 1, whose top stands out by `overhang`, in the middle of a plate: the
/// length of the lines at its foot, seen from above.
double seen_foot(double overhang) {
    const double top = 0.5 + overhang;
    const Scene scene{test_meshes::stacked({{2, 2, -1}, {2, 2, 0}, {0.5, 0.5, 0}, {top, top, 1}})};
    const auto view = View::orthographic({0, 0, 1});
    LineStyle style = helpers::all_contours();
    style.shows[LineKind::Crease] = true;
    return length_of(
        scene.visibility.visible_lines(view, {scene.on_surface(view, style)}, {style.shows}),
        [](const ViewLine&, const Vector3d& p) {
            return p.z() < 0.5 && p.head<2>().cwiseAbs().maxCoeff() < 1;
        });
}

TEST(LineVisibility, FeetOfWallsAreSeenBesideTheWallsUnevenness) {
    EXPECT_NEAR(seen_foot(-1e-6), 4, 1e-3);
    EXPECT_NEAR(seen_foot(1e-6), 4, 1e-3);
    EXPECT_EQ(seen_foot(1e-3), 0);
}

}  // namespace
