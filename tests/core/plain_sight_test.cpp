// SPDX-License-Identifier: GPL-3.0-or-later
// Sight, and the searches behind it, by the plainest means.
#include "plain_sight.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "helpers.h"
#include "laplacian_lines/progress.h"
#include "registry.h"
#include "visibility/sight_pieces.h"

namespace {

using namespace laplacian_lines;
using namespace plain_sight;
using Eigen::Vector3d;

/// On triangles, in arbitrary directions.
LineSet random_lines(const TriangleMesh& mesh, int count, double least_length, unsigned seed) {
    std::mt19937 random(seed);
    LineSet lines;
    for (int tries = 0; lines.lines.size() < std::size_t(count) && tries < 100 * count; ++tries) {
        const Triangle& t = mesh.triangles[random() % mesh.triangles.size()];
        const auto place = [&]() -> Vector3d {
            const double a = random_unit(random), b = (1 - a) * random_unit(random);
            return a * mesh.positions[t[0]] + b * mesh.positions[t[1]] +
                   (1 - a - b) * mesh.positions[t[2]];
        };
        const Vector3d from = place(), to = place();
        if (!((to - from).norm() >= least_length)) continue;
        Polyline line;
        line.first = std::uint32_t(lines.points.size());
        line.count = 2;
        lines.lines.push_back(line);
        lines.points.push_back({from.cast<float>(), 1, 1, 1});
        lines.points.push_back({to.cast<float>(), 1, 1, 1});
    }
    return lines;
}

/// Of a place, and all nearby on its line from all nearby eyes.
enum class Sight { Seen, Hidden, Unsure };

class PlainSight {
public:
    PlainSight(const TriangleMesh& mesh, const View& view)
        : mesh_(mesh), view_(view), diagonal_(box_of(mesh).diagonal) {}

    /// In the middle of a line: parts and gaps below .3 % of D do not count.
    Sight look(const Vector3d& p, const Vector3d& direction) const {
        bool is_first = true, hidden = false;
        for (const double along :
             {0., -3.6e-3, 3.6e-3, -1e-4, 1e-4, -1e-3, 1e-3, -2e-3, 2e-3, -3e-3, 3e-3})
            for (const Vector3d& turn : turns()) {
                View view = view_;
                view.eye += 1e-4 * (view_.eye - view_.w * p).norm() * turn;
                const bool is =
                    is_hidden(mesh_, view, p + along * diagonal_ * direction, 1e-6 * diagonal_);
                if (!is_first && is != hidden) return Sight::Unsure;
                is_first = false;
                hidden = is;
            }
        return hidden ? Sight::Hidden : Sight::Seen;
    }

private:
    static std::vector<Vector3d> turns() {
        return {{0, 0, 0}, {1, 0, 0}, {-0.5, 0.87, 0}, {-0.5, -0.87, 0}, {0, 0.3, 1}, {0, 0, -1}};
    }

    const TriangleMesh& mesh_;
    const View& view_;
    const double diagonal_;
};

struct Counts {
    int seen = 0, hidden = 0;
};

Counts expect_plain_sight(const TriangleMesh& mesh, const View& view, unsigned seed) {
    const double d = box_of(mesh).diagonal;
    const LineSet lines = random_lines(mesh, 40, 0.01 * d, seed);
    const auto seen = LineVisibility(mesh).parts(view, {lines}, {LineKindSet(), 0}).seen;
    const PlainSight plain(mesh, view);
    const auto is_edge_on = [&](const Vector3d& p) {  // the triangle: then rays run along it
        return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
            const Vector3d& a = mesh.positions[t[0]];
            const Vector3d n =
                (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).normalized();
            return std::abs(n.dot(p - a)) < 1e-6 * d &&
                   std::abs(n.dot(towards_eye(view, p))) < 0.01;
        });
    };
    std::mt19937 random(seed);
    Counts counts;
    for (const Polyline& line : lines.lines) {
        const Vector3d a = lines.points[line.first].position.cast<double>(),
                       b = lines.points[line.first + 1].position.cast<double>();
        const double length = (b - a).norm(), margin = 0.004 * d / length;
        const Vector3d p = a + (margin + (1 - 2 * margin) * random_unit(random)) * (b - a);
        if (is_edge_on(p)) continue;
        const Sight sight = plain.look(p, (b - a) / length);
        if (sight == Sight::Unsure) continue;
        ++(sight == Sight::Seen ? counts.seen : counts.hidden);
        EXPECT_EQ(helpers::distance_to_lines(p, seen) < 1e-6 * d, sight == Sight::Seen)
            << p.transpose();
    }
    return counts;
}

/// Few triangles, long lines.
struct CoarseMesh {
    const char* name;
    TriangleMesh mesh;
};

std::vector<CoarseMesh> coarse_meshes() {
    TriangleMesh soup = test_meshes::mesh_named("triangle_soup").mesh;
    soup.triangles.resize(50);
    TriangleMesh flipped = test_meshes::torus(20, 10, 0.2).mesh;
    test_meshes::flip_triangles(flipped, 3);
    return {{"soup", soup},
            {"flipped_torus", flipped},
            {"torus", test_meshes::torus(24, 12).mesh},
            {"half_torus", test_meshes::half_torus(16, 12).mesh},
            {"cube", test_meshes::cube(3)},
            {"five_sheets", test_meshes::fan_of_sheets(5, 3)},
            {"moebius_strip", test_meshes::moebius_strip(36, 6)},
            {"scattered_spheres", test_meshes::mesh_named("scattered_spheres").mesh}};
}

TEST(PlainSight, IsThatOfLineVisibility) {
    for (const CoarseMesh& coarse : coarse_meshes()) {
        const TriangleMesh& mesh = coarse.mesh;
        Counts all;
        unsigned seed = 0;
        for (const View& view : views_from(special_directions(), box_of(mesh))) {
            if (++seed % 5 != 0) continue;
            SCOPED_TRACE(testing::Message() << coarse.name << ", " << words(view));
            const Counts counts = expect_plain_sight(mesh, view, seed);
            all.seen += counts.seen;
            all.hidden += counts.hidden;
        }
        EXPECT_GT(all.seen, 10) << coarse.name;
        EXPECT_GT(all.hidden, 10) << coarse.name;
    }
}

// --- searches

struct PlainCrossing {
    std::array<double, 2> shares;  ///< of the way
    bool is_sure;                  ///< not only by rounding
};
/// By pairs of segments, the lower number first.
using Crossings = std::map<std::pair<std::uint32_t, std::uint32_t>, PlainCrossing>;

/// Surely; others may be behind one another.
bool is_within(double share) {
    return share > 1e-6 && share < 1 - 1e-6;
}

Crossings plain_crossings(const SightSegments& all) {
    Crossings crossings;
    const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return Picture::turn(all.place(a), all.place(b), all.place(c));
    };
    for (std::uint32_t i = 0; i < all.segments.size(); ++i)
        for (std::uint32_t k = i + 1; k < all.segments.size(); ++k) {
            const SightSegment &s = all.segments[i], &o = all.segments[k];
            if (!s.divides && !o.divides) continue;
            const auto [a, b] = s.points;
            const auto [c, e] = o.points;
            if (a == c || a == e || b == c || b == e) continue;
            if (turn(a, b, c) == turn(a, b, e) || turn(c, e, a) == turn(c, e, b)) continue;
            using Vector2 = Eigen::Vector2d;
            const Vector2 p = all.place(a).head<2>(), r = all.place(b).head<2>() - p,
                          q = all.place(c).head<2>(), v = all.place(e).head<2>() - q;
            const auto cross = [](const Vector2& x, const Vector2& y) {
                return x.x() * y.y() - x.y() * y.x();
            };
            const double t = cross(q - p, v) / cross(r, v), u = cross(q - p, r) / cross(r, v);
            const double z = all.place(a).z() + t * (all.place(b).z() - all.place(a).z()),
                         w = all.place(c).z() + u * (all.place(e).z() - all.place(c).z());
            // Lines on the surface do not divide; what is before them crosses them.
            const double before = o.line != SightSegment::kNone   ? w - z
                                  : s.line != SightSegment::kNone ? z - w
                                                                  : 0;
            // With surface on both sides it hides as much on one as on the other.
            const bool ends = describe(s.kind).is_outline || describe(o.kind).is_outline;
            if (before < 1e-4 && (ends || std::abs(z - w) < 1e-4))
                crossings[{i, k}] = {{t, u}, ends && before <= 0 && is_within(t) && is_within(u)};
        }
    return crossings;
}

/// Returns their number.
std::size_t expect_plain_crossings(const SightSegments& all) {
    const Crossings expected = plain_crossings(all);
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for (const PictureCrossing& crossing : find_crossings(all, StageProgress({}, 0, 1, ""))) {
        const std::uint32_t *s = crossing.segments, first = s[0] < s[1] ? 0 : 1;
        const std::pair<std::uint32_t, std::uint32_t> pair = {s[first], s[1 - first]};
        EXPECT_TRUE(found.insert(pair).second) << pair.first << ", " << pair.second;
        const auto plain = expected.find(pair);
        if (plain == expected.end()) {
            ADD_FAILURE() << pair.first << ", " << pair.second << " do not cross";
            continue;
        }
        for (const std::size_t i : {0u, 1u}) {
            const double share = crossing.shares[i == 0 ? first : 1 - first],
                         plain_share = plain->second.shares[i];
            EXPECT_TRUE(share >= 0 && share <= 1) << share;
            if (plain_share > 0 && plain_share < 1) {
                EXPECT_NEAR(share, plain_share, 1e-3);
            }
        }
    }
    for (const auto& [pair, crossing] : expected)
        EXPECT_TRUE(!crossing.is_sure || found.count(pair) == 1)
            << pair.first << ", " << pair.second;
    return found.size();
}

TEST(PictureCrossings, AreThoseOfAllPairs) {
    std::size_t total = 0;
    for (const CoarseMesh& coarse : coarse_meshes()) {
        const TriangleMesh& mesh = coarse.mesh;
        const SightMesh sight_mesh = build_sight_mesh(mesh, StageProgress({}, 0, 1, ""));
        const LineSet lines = random_lines(mesh, 200, 0.01 * box_of(mesh).diagonal, 3);
        unsigned number = 0;
        for (const View& view : views_from(special_directions(), box_of(mesh))) {
            if (++number % 9 != 0) continue;
            SCOPED_TRACE(testing::Message() << coarse.name << ", " << words(view));
            const Picture picture(sight_mesh, EyeFrame(sight_mesh, view),
                                  StageProgress({}, 0, 1, ""));
            total += expect_plain_crossings(find_sight_segments(picture, {}, {lines}));
        }
    }
    EXPECT_GT(total, 1000u);
}

template <int Dim>
typename BoxTree<Dim>::Box random_box(std::mt19937& random, double largest) {
    using Point = Eigen::Matrix<float, Dim, 1>;
    Point low, high;
    const double size = largest * std::pow(2, -12 * random_unit(random));
    for (int i = 0; i < Dim; ++i) {
        low[i] = float(2 * random_unit(random) - 1);
        high[i] = low[i] + float(random() % 4 == 0 ? 0 : size * random_unit(random));
    }
    return {low, high};
}

template <int Dim>
std::vector<std::uint32_t> order_of(const std::vector<typename BoxTree<Dim>::Box>& boxes) {
    using Point = Eigen::Matrix<float, Dim, 1>;
    return order_along_curve<Dim>(boxes.size(), {Point::Constant(-1), Point::Constant(1)},
                                  [&](std::uint32_t i) -> Point { return boxes[i].center(); });
}

/// Of this many boxes: what meets another box, and which pairs meet.
template <int Dim>
void expect_plain_visits(std::size_t count) {
    using Tree = BoxTree<Dim>;
    std::mt19937 random{unsigned(count)};
    std::vector<typename Tree::Box> boxes;
    for (std::size_t i = 0; i < count; ++i)
        boxes.push_back(random_box<Dim>(random, 1));
    const std::vector<std::uint32_t> order = order_of<Dim>(boxes);
    const Tree tree(order, [&](std::uint32_t i) { return boxes[i]; });
    for (int query = 0; query < 50; ++query) {
        const typename Tree::Box box = random_box<Dim>(random, 0.5);
        std::multiset<std::uint32_t> found, expected;
        tree.visit(box, [&](std::uint32_t i) {
            found.insert(i);
            return true;
        });
        for (std::uint32_t i = 0; i < count; ++i)
            if (boxes[i].intersects(box)) expected.insert(i);
        EXPECT_EQ(found, expected);
    }
    std::multiset<std::pair<std::size_t, std::size_t>> found, expected;
    for (const auto& pair : tree.pairs())
        tree.visit_pairs(pair, [&](std::size_t i, std::size_t k) { found.emplace(i, k); });
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = i + 1; k < count; ++k)
            if (boxes[order[i]].intersects(boxes[order[k]])) expected.emplace(i, k);
    EXPECT_EQ(found, expected);
}

TEST(BoxTree, VisitsWhatMeetsABoxAndAllPairs) {
    for (const std::size_t count : {0, 1, 2, 5, 17, 200, 3000}) {
        expect_plain_visits<2>(count);
        expect_plain_visits<3>(count);
    }
}

TEST(BoxTree, StopsWhereAVisitSaysSo) {
    std::mt19937 random(1);
    std::vector<BoxTree<2>::Box> boxes(100, {Eigen::Vector2f(-1, -1), Eigen::Vector2f(1, 1)});
    const std::vector<std::uint32_t> order = order_of<2>(boxes);
    int visits = 0;
    BoxTree<2>(order, [&](std::uint32_t i) {
        return boxes[i];
    }).visit(boxes[0], [&](std::uint32_t) { return ++visits < 7; });
    EXPECT_EQ(visits, 7);
}

/// Every number once, with short steps: in a plane of n points of the order of 1 / √n.
TEST(OrderAlongCurve, KeepsNeighboursTogether) {
    std::mt19937 random(5);
    std::vector<BoxTree<2>::Box> points;
    for (int i = 0; i < 20000; ++i)
        points.push_back(random_box<2>(random, 0));
    std::vector<std::uint32_t> order = order_of<2>(points);
    double path = 0;
    for (std::size_t i = 1; i < order.size(); ++i)
        path += double((points[order[i]].center() - points[order[i - 1]].center()).norm());
    EXPECT_LT(path / double(order.size()), 3 * 2 / std::sqrt(double(order.size())));
    std::sort(order.begin(), order.end());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        ASSERT_EQ(order[i], i);
}

}  // namespace
