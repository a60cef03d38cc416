// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of lines are seen, on surfaces whose outlines are known.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "helpers.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "mesh_noise.h"

namespace {

using namespace laplacian_lines;
using helpers::extract;

const double kPi = std::acos(-1.0);

/// A mesh with all that looking at its lines takes.
struct Scene {
    TriangleMesh mesh;
    Field field = precompute(mesh);
    LineExtractor extractor{mesh, field};
    LineVisibility visibility{mesh, field};

    LineSet visible(const View& view, const LineStyle& style) const {
        return visibility.visible_parts(view, extract(extractor, view, style));
    }
};

TriangleMesh ball(const Eigen::Vector3d& centre) {
    TriangleMesh mesh = test_meshes::sphere(5).mesh;
    for (Eigen::Vector3d& p : mesh.positions)
        p += centre;
    return mesh;
}

/// Two unit spheres: one at the origin, seen from +z, one well behind it and a radius to the right.
Scene two_balls() {
    TriangleMesh mesh = ball({0, 0, 0});
    test_meshes::append(mesh, ball({1, 0, -4}));
    return {mesh};
}

/// In D.
double length_of(const LineSet& lines) {
    return std::accumulate(
        lines.lines.begin(), lines.lines.end(), 0.,
        [](double sum, const Polyline& line) { return sum + double(line.length); });
}

bool is_in_front(const LineSet& lines, const Polyline& line) {
    return lines.points[line.first].position.z() > -2;
}

/// The far outline is hidden where it is within the near one: 120 degrees of it.
TEST(LineVisibility, NearBallHidesAThirdOfTheFarOnesOutline) {
    const Scene scene = two_balls();
    const View view = View::orthographic(Eigen::Vector3d::UnitZ());
    const LineSet lines = scene.visible(view, helpers::all_contours());
    ASSERT_EQ(lines.lines.size(), 2u);
    for (const Polyline& line : lines.lines) {
        const double length = double(line.length) * scene.field.scale.diagonal;
        EXPECT_EQ(line.closed, is_in_front(lines, line));
        EXPECT_NEAR(length, is_in_front(lines, line) ? 2 * kPi : 4 * kPi / 3, 0.03);
        if (line.closed) continue;
        for (const LinePoint& end :
             {lines.points[line.first], lines.points[line.first + line.count - 1]}) {
            EXPECT_NEAR(end.position.x(), 0.5, 0.02);
            EXPECT_NEAR(std::abs(end.position.y()), std::sqrt(0.75), 0.02);
        }
    }
}

/// The same of two surfaces with fields of their own.
TEST(LineVisibility, SurfacesHideEachOther) {
    const Scene near{ball({0, 0, 0})}, far{ball({1, 0, -4})};
    const LineVisibility both(two_balls().mesh, {&near.field, &far.field});
    const View view = View::orthographic(Eigen::Vector3d::UnitZ());
    const auto outlines = [&](const Scene& scene) {
        return extract(scene.extractor, view, helpers::all_contours());
    };
    const LineParts parts = both.parts(view, {outlines(near), outlines(far)});
    ASSERT_EQ(parts.seen.lines.size(), 2u);
    ASSERT_EQ(parts.hidden.lines.size(), 1u);
    for (const Polyline& line : parts.seen.lines)
        EXPECT_EQ(line.closed, is_in_front(parts.seen, line));
    const double length = double(parts.hidden.lines[0].length) * far.field.scale.diagonal;
    EXPECT_NEAR(length, 2 * kPi / 3, 0.03);
}

/// A surface is judged by its own lengths, also beside one that is a thousand times as large.
TEST(LineVisibility, ALargeSurfaceDoesNotBlurASmallOne) {
    const Scene small{test_meshes::torus(120, 60).mesh};
    TriangleMesh mesh = small.mesh, large_ball = test_meshes::sphere(4).mesh;
    for (Eigen::Vector3d& p : large_ball.positions)
        p = 1000 * p + Eigen::Vector3d(2000, 0, 0);
    const Field large_field = precompute(large_ball);
    test_meshes::append(mesh, large_ball);
    const View view = View::orthographic({0, 1, 0.5});
    const LineSet lines = extract(small.extractor, view, helpers::all_contours());
    const LineParts alone = small.visibility.parts(view, lines);
    const LineParts beside =
        LineVisibility(mesh, {&small.field, &large_field}).parts(view, {lines, LineSet()});
    ASSERT_FALSE(alone.hidden.lines.empty());
    EXPECT_EQ(beside.seen.lines.size(), alone.seen.lines.size());
    EXPECT_NEAR(length_of(beside.hidden), length_of(alone.hidden), 0.01);
}

TEST(LineVisibility, EyeBetweenTheBallsSeesTheFarOutlineWhole) {
    const Scene scene = two_balls();
    const View view = View::perspective({1, 0, -1.5});
    const LineSet lines = scene.visible(view, helpers::all_contours());
    ASSERT_FALSE(lines.lines.empty());
    for (const Polyline& line : lines.lines)
        EXPECT_TRUE(line.closed);
}

/// From where no line is hidden all stay just as they are, closed ones closed.
TEST(LineVisibility, KeepsWhatNothingHides) {
    const Scene scene{test_meshes::hills(40).mesh};
    const View view = View::orthographic(Eigen::Vector3d::UnitZ());
    const LineSet all = extract(scene.extractor, view, helpers::all_laplacian_lines());
    ASSERT_GT(all.lines.size(), 3u);
    EXPECT_TRUE(helpers::same_lines(all, scene.visibility.visible_parts(view, all)));
}

// --- against a torus that is known exactly, not by triangles

constexpr test_meshes::Torus kTorus;

/// Whether the straight way from p to the eye is anywhere this deep inside the solid torus, by
/// walking along it.
bool torus_hides(const Eigen::Vector3d& p, const View& view, double clearance, double depth) {
    const Eigen::Vector3d to_eye = view.eye - view.w * p;
    const double step = 2e-3, reach = view.w == 0 ? 6 : std::min(6.0, to_eye.norm());
    for (double t = clearance; t < reach; t += step) {
        const Eigen::Vector3d q = p + t * to_eye.normalized();
        const double ring = std::hypot(q.x(), q.y()) - kTorus.large;
        if (std::hypot(ring, q.z()) < kTorus.small - depth) return true;
    }
    return false;
}

void expect_true_visibility(const Scene& scene, const View& view) {
    const LineSet all = extract(scene.extractor, view, helpers::all_crossings());
    const LineSet seen = scene.visibility.visible_parts(view, all);
    const double d = scene.field.scale.diagonal;
    const double clearance = sight_clearance(LineKind::Contour, d, sight_edge(scene.field));
    int sure = 0, hidden = 0, wrong = 0;
    for (const LinePoint& point : all.points) {
        const Eigen::Vector3d p = point.position.cast<double>();
        const bool is_hidden = torus_hides(p, view, 1.5 * clearance, 0.003 * d);
        if (is_hidden != torus_hides(p, view, 0.1 * clearance, 1e-4)) continue;  // at the horizon
        ++sure;
        hidden += is_hidden;
        wrong += is_hidden == (helpers::distance_to_lines(p, seen) < 1e-6 * d);
    }
    EXPECT_GT(hidden, sure / 10);
    EXPECT_LT(hidden, sure * 9 / 10);
    EXPECT_LE(wrong, sure / 100) << "of " << sure;
}

TEST(LineVisibility, AgreesWithTheExactTorus) {
    const Scene scene{test_meshes::torus(160, 80).mesh};
    expect_true_visibility(scene, View::orthographic({0.2, -1, 0.6}));
    expect_true_visibility(scene, View::perspective({0.5, -3, 1.5}));
    expect_true_visibility(scene, View::perspective({3, 0.3, 0.1}));
}

// --- lines of few points

/// A triangle strip of one quadrangle, a × b around a centre, facing +z.
void add_rectangle(TriangleMesh& mesh, const Eigen::Vector3d& centre, double a, double b) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const auto& corner : {Eigen::Vector3d(-a, -b, 0), Eigen::Vector3d(a, -b, 0),
                               Eigen::Vector3d(a, b, 0), Eigen::Vector3d(-a, b, 0)})
        mesh.positions.push_back(centre + corner / 2);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

/// A bar across the middle of a long segment, whose ends are seen.
TEST(LineVisibility, HidesTheMiddleOfALongSegment) {
    TriangleMesh mesh;
    add_rectangle(mesh, {0, 0, 0}, 4, 1);
    add_rectangle(mesh, {0, 0, 1}, 0.5, 3);
    const Scene scene{mesh};
    LineSet line;
    line.points = {{{-1.5f, 0.25f, 0}, 0, 10, 1}, {{1.5f, 0.25f, 0}, 1, 20, 1}};
    line.lines = {{0, 2, LineKind::Crease, false, 7, 0.6f, 5}};
    const View view = View::orthographic(Eigen::Vector3d::UnitZ());
    const LineSet seen = scene.visibility.visible_parts(view, line);
    ASSERT_EQ(seen.lines.size(), 2u);
    ASSERT_EQ(seen.points.size(), 4u);
    const double d = scene.field.scale.diagonal;
    EXPECT_NEAR(seen.points[1].position.x(), -0.25, 1e-3 * d);
    EXPECT_NEAR(seen.points[2].position.x(), 0.25, 1e-3 * d);
    EXPECT_NEAR(seen.points[2].weight, 1.75 / 3, 1e-3);
    EXPECT_NEAR(seen.points[1].gradient, 10 + 10 * 1.25 / 3, 1e-2);
    for (const Polyline& part : seen.lines) {
        EXPECT_EQ(part.kind, LineKind::Crease);
        EXPECT_EQ(part.strength, 7);
        EXPECT_EQ(part.slope, 5);
        EXPECT_NEAR(part.length * d, 1.25, 2e-3 * d);
    }
    // from the other side nothing is before it, but the rectangle that it lies in
    EXPECT_EQ(scene.visibility.visible_parts(View::orthographic({0, 0.01, -1}), line).lines.size(),
              1u);
    EXPECT_TRUE(
        scene.visibility.visible_parts(View::perspective({0, 0.25, 1.5}), line).lines.size() == 2);
}

/// The mesh's coordinates may lie anywhere.
TEST(LineVisibility, FarFromTheOrigin) {
    TriangleMesh mesh = two_balls().mesh;
    const Eigen::Vector3d offset(4096, -2048, 8192);
    for (Eigen::Vector3d& p : mesh.positions)
        p += offset;
    const Scene scene{mesh};
    const LineSet lines = scene.visible(View::perspective(offset + Eigen::Vector3d(0, 0, 50)),
                                        helpers::all_contours());
    EXPECT_EQ(lines.lines.size(), 2u);
}

TEST(LineVisibility, TellsInsideFromOutside) {
    const Scene scene = two_balls();
    EXPECT_TRUE(scene.visibility.encloses({0, 0, 0}));
    EXPECT_TRUE(scene.visibility.encloses({1.9, 0, -4}));
    EXPECT_FALSE(scene.visibility.encloses({0, 0, 1.1}));
    EXPECT_FALSE(scene.visibility.encloses({0.5, 0, -2}));
    TriangleMesh room = scene.mesh;
    test_meshes::flip_triangles(room, 1);
    EXPECT_FALSE(LineVisibility(room, scene.field).encloses({0, 0, 0}));
}

TEST(LineVisibility, CancelsAndReports) {
    const Scene scene = two_balls();
    const View view = View::orthographic({1, 2, 3});
    const LineSet lines = extract(scene.extractor, view, helpers::all_crossings());
    double last = -1;
    (void)scene.visibility.visible_parts(view, lines, [&](double done, const char*) {
        EXPECT_GE(done, last);
        last = done;
        return true;
    });
    EXPECT_GE(last, 0);
    try {
        (void)scene.visibility.visible_parts(view, lines,
                                             [](double, const char*) { return false; });
        FAIL() << "not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    }
}

TEST(LineVisibility, ContoursAreClearedByEdgesUnlessTheyFollowThem) {
    const Field fine = precompute(test_meshes::sphere(5).mesh);
    EXPECT_NEAR(sight_edge(fine), fine.scale.mean_edge, 1e-9);
    EXPECT_EQ(sight_edge(precompute(test_meshes::cube(2))), 0);
    EXPECT_EQ(sight_clearance(LineKind::Contour, 10, 0), 0.03);
    EXPECT_NEAR(sight_clearance(LineKind::Contour, 10, 0.1), 0.15, 1e-12);
    EXPECT_EQ(sight_clearance(LineKind::Ridge, 10, 0.1), 0.03);
}

/// Contours of rough meshes are smooth, beyond the horizon by as much as the triangles are large.
TEST(LineVisibility, OutlinesOfCoarseNoisyMeshesHaveNoGaps) {
    const Scene scene{mesh_noise::with_noise(test_meshes::torus(54, 27).mesh, 0.2)};
    ASSERT_GT(scene.field.scale.mean_edge, 0.025 * scene.field.scale.diagonal);
    ASSERT_GT(sight_edge(scene.field), 0);
    const View view = View::orthographic(Eigen::Vector3d::UnitZ());  // nothing is before an outline
    const auto length = [](const LineSet& lines) {
        return std::accumulate(
            lines.lines.begin(), lines.lines.end(), 0.,
            [](double sum, const Polyline& line) { return sum + double(line.length); });
    };
    EXPECT_GT(length(scene.visible(view, helpers::all_contours())),
              0.95 * length(extract(scene.extractor, view, helpers::all_contours())));
}

TEST(LineVisibility, RefusesTrianglesWithoutVertices) {
    TriangleMesh mesh = two_balls().mesh;
    const Field field = precompute(mesh);
    mesh.triangles.push_back({0, 1, 1000000});
    try {
        LineVisibility visibility(mesh, field);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidMesh);
    }
}

}  // namespace
