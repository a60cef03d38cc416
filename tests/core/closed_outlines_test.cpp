// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing's outlines are closed and enclose what the mesh covers: for any mesh and eye, even if
// edges and faces line up.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <random>
#include <string>

#include "laplacian_lines/line_visibility.h"
#include "registry.h"
#include "tie_views.h"

namespace {

using namespace laplacian_lines;
using namespace tie_views;
using Eigen::Vector2d;
using Eigen::Vector3d;
using test_meshes::mapped;
using test_meshes::signed_unit;

/// Unit.
Vector3d towards_eye(const View& view, const Vector3d& point) {
    return (view.eye - view.w * point).normalized();
}

/// How far along a line, negative behind its origin; NaN if the line misses.
double meeting(const TriangleMesh& mesh, const Triangle& t, const Vector3d& origin,
               const Vector3d& direction) {
    const Vector3d &a = mesh.positions[t[0]], ab = mesh.positions[t[1]] - a,
                   ac = mesh.positions[t[2]] - a;
    const Vector3d p = direction.cross(ac), s = origin - a, q = s.cross(ab);
    const double determinant = ab.dot(p);
    if (determinant == 0) return test_meshes::kNaN;
    const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 ? ac.dot(q) / determinant : test_meshes::kNaN;
}

/// Whether the mesh is seen at a point's place in the picture, before or behind the point.
bool is_covered(const TriangleMesh& mesh, const View& view, const Vector3d& point) {
    const Vector3d direction = towards_eye(view, point);
    return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
        const double at = meeting(mesh, t, point, direction);
        return view.w != 0 ? at < (view.eye / view.w - point).norm() : at == at;
    });
}

/// What is seen on a plane through `point`.
class SeenPlane {
public:
    SeenPlane(const View& view, const Vector3d& point)
        : view_(view),
          point_(point),
          normal_(towards_eye(view, point)),
          right_(normal_.unitOrthogonal()),
          up_(normal_.cross(right_)) {}

    Vector2d place(const Vector3d& p) const {
        Vector3d on = p - point_;
        if (view_.w != 0) {
            const Vector3d eye = view_.eye / view_.w - point_;
            on = eye + eye.dot(normal_) / (eye - on).dot(normal_) * (on - eye);
        }
        return {right_.dot(on), up_.dot(on)};
    }

private:
    const View& view_;
    const Vector3d point_, normal_, right_, up_;
};

double distance_to_segment(const Vector2d& a, const Vector2d& b) {
    const Vector2d direction = b - a;
    const double length = direction.squaredNorm();
    const double t = length > 0 ? std::clamp(-direction.dot(a) / length, 0., 1.) : 0;
    return (a + t * direction).norm();
}

/// Whether the outlines enclose a point an odd number of times, in the picture, and its distance
/// from them on the SeenPlane through it.
struct OutlinePlace {
    bool is_inside;
    double distance;
};
OutlinePlace place_in_outlines(const std::vector<ViewLine>& lines, const View& view,
                               const Vector3d& point) {
    const SeenPlane plane(view, point);
    OutlinePlace result{false, test_meshes::kInfinity};
    for (const ViewLine& line : lines) {
        if (!line.is_outline) continue;
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const Vector2d a = plane.place(line.points[i - 1].position),
                           b = plane.place(line.points[i].position);
            result.distance = std::min(result.distance, distance_to_segment(a, b));
            const bool passes = (a.y() > 0) != (b.y() > 0);
            if (passes && a.x() - a.y() * (b.x() - a.x()) / (b.y() - a.y()) > 0)
                result.is_inside = !result.is_inside;
        }
    }
    return result;
}

/// Coordinates from -1 to 1.
Vector3d random_vector(std::mt19937& random) {
    const double x = signed_unit(random), y = signed_unit(random);
    return {x, y, signed_unit(random)};
}

std::size_t outlines(const std::vector<ViewLine>& lines, bool closed) {
    return std::size_t(std::count_if(lines.begin(), lines.end(), [=](const ViewLine& line) {
        return line.is_outline && line.closed == closed;
    }));
}

/// At random places of the picture.
void expect_covered_within(const std::vector<ViewLine>& lines, const TriangleMesh& mesh,
                           const View& view, const Eigen::AlignedBox3d& box) {
    const double d = box.diagonal().norm();
    std::mt19937 random(11);
    int compared = 0;
    for (int i = 0; i < 60; ++i) {
        const Vector3d p = box.center() + 0.6 * d * random_vector(random);
        const OutlinePlace place = place_in_outlines(lines, view, p);
        if (place.distance < 2e-4 * d) continue;
        ++compared;
        EXPECT_EQ(place.is_inside, is_covered(mesh, view, p)) << p.transpose();
    }
    EXPECT_GT(compared, 30);
}

void expect_closed_outlines(const TriangleMesh& mesh, const std::vector<Vector3d>& directions) {
    const LineVisibility visibility(mesh);
    Eigen::AlignedBox3d box;
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            if (mesh.positions[v].allFinite()) box.extend(mesh.positions[v]);
    const VisibilityOptions options{edge_kinds(), 1.2, false, true};
    std::size_t closed = 0;
    for (const View& view : views_from(directions, box.center(), box.diagonal().norm())) {
        SCOPED_TRACE(words(view));
        const std::vector<ViewLine> lines = visibility.visible_lines(view, {}, options);
        EXPECT_EQ(outlines(lines, false), 0u);
        closed += outlines(lines, true);
        expect_covered_within(lines, mesh, view, box);
    }
    EXPECT_GT(closed, 0u);
}

/// A quarter of the special ones, by seed.
std::vector<Vector3d> some_directions(unsigned seed) {
    const std::vector<Vector3d> all = special_directions();
    std::vector<Vector3d> some;
    for (std::size_t i = seed % 4; i < all.size(); i += 4)
        some.push_back(all[i]);
    return some;
}

class ClosedOutlines : public testing::TestWithParam<std::string> {};

TEST_P(ClosedOutlines, FromAllSides) {
    const TriangleMesh& mesh = test_meshes::mesh_named(GetParam()).mesh;
    expect_closed_outlines(mesh, special_directions());
}

std::vector<std::string> drawable_meshes() {
    std::vector<std::string> names = test_meshes::mesh_names();
    names.erase(std::find(names.begin(), names.end(), "triangle_soup"));  // takes minutes
    return names;
}
INSTANTIATE_TEST_SUITE_P(Registry, ClosedOutlines, testing::ValuesIn(drawable_meshes()),
                         [](const auto& info) { return info.param; });

TEST(ClosedOutlines, OfANoisyMesh) {
    expect_closed_outlines(test_meshes::with_noise(test_meshes::torus(54, 27).mesh, 0.2),
                           special_directions());
}

/// Of any winding, some twice.
TriangleMesh soup(unsigned seed, int triangles,
                  const std::function<Vector3d(std::mt19937&)>& corner) {
    std::mt19937 random(seed);
    TriangleMesh mesh;
    for (int i = 0; i < triangles; ++i) {
        const auto first = std::uint32_t(mesh.positions.size());
        for (int k = 0; k < 3; ++k)
            mesh.positions.push_back(corner(random));
        mesh.triangles.push_back({first, first + 1, first + 2});
        if (random() % 5 == 0) mesh.triangles.push_back({first + 1, first, first + 2});
    }
    return mesh;
}

Vector3d grid_corner(std::mt19937& random) {
    const double x = random() % 4, y = random() % 4;
    return {x, y, double(random() % 4)};
}

/// Corners on a grid: triangles are coplanar, share parts of edges, have corners on others' edges
/// and faces.
TEST(ClosedOutlines, OfTriangleSoupsOnAGrid) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        expect_closed_outlines(soup(seed, 2 + int(seed % 3), grid_corner), some_directions(seed));
    }
}

/// A cube of loose triangles of any winding, some cut in two regardless of their neighbours.
TriangleMesh cube_with_junctions(unsigned seed) {
    std::mt19937 random(seed);
    const TriangleMesh cube = test_meshes::cut_apart(test_meshes::cube(2));
    TriangleMesh mesh{cube.positions, {}};
    for (const Triangle& t : cube.triangles) {
        const std::uint32_t k = random() % 3;
        const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
        if (random() % 2 != 0) {
            mesh.triangles.push_back({b, a, c});
            continue;
        }
        const double share = random() % 2 != 0 ? 0.5 : (1 + signed_unit(random)) / 2;
        const auto middle = std::uint32_t(mesh.positions.size());
        mesh.positions.push_back(cube.positions[a] +
                                 share * (cube.positions[b] - cube.positions[a]));
        mesh.triangles.push_back({a, middle, c});
        mesh.triangles.push_back({b, middle, c});
    }
    return mesh;
}

TEST(ClosedOutlines, OfMeshesWithTJunctions) {
    for (unsigned seed = 0; seed < 16; ++seed) {
        SCOPED_TRACE(seed);
        TriangleMesh mesh = cube_with_junctions(seed);
        if (seed % 2 != 0)  // so that coordinates are rounded
            for (Vector3d& p : mesh.positions)
                p = Eigen::AngleAxisd(seed, Vector3d(1, 2, 3).normalized()) * p;
        expect_closed_outlines(mesh, some_directions(seed));
    }
}

/// Boxes on a grid share faces, edges and corners, but for rounding.
TEST(ClosedOutlines, OfBoxesThatTouchWithinRounding) {
    for (unsigned seed = 0; seed < 24; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        TriangleMesh mesh;
        for (unsigned boxes = 2 + seed % 4; boxes > 0; --boxes) {
            const Vector3d low = grid_corner(random), size = Vector3d::Ones() + grid_corner(random);
            test_meshes::append(mesh, mapped(test_meshes::cube(1), [&](Vector3d& p) {
                                    p = low + size.cwiseProduct(p + Vector3d::Ones()) +
                                        1e-7 * random_vector(random);
                                }));
        }
        expect_closed_outlines(mesh, some_directions(seed));
    }
}

TEST(ClosedOutlines, OfBoxesThroughEachOther) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE(seed);
        const TriangleMesh one = test_meshes::cube(1),
                           other = mapped(one, [=](Vector3d&p) {
                               if (seed % 2 != 0)
                                   p = Eigen::AngleAxisd(0.2 * seed, Vector3d::UnitZ()) * p;
                               p += Vector3d(0.5 * (seed % 3), 0.25 * (seed % 4), 0.5);
                           });
        expect_closed_outlines(test_meshes::together(one, other), special_directions());
    }
}

}  // namespace
