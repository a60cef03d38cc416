// SPDX-License-Identifier: GPL-3.0-or-later
// How it is decided which parts of lines are seen, and what follows for them.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <numeric>
#include <random>

#include "helpers.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "thrown_vessel.h"
#include "visibility/chain_labels.h"
#include "visibility/layers.h"
#include "visibility/line_parts.h"
#include "visibility/picture_crossings.h"

namespace {

using namespace laplacian_lines;
using helpers::extract;

template <std::size_t Count>
double cost_of(const std::vector<LabelCosts<Count>>& pieces, bool closed,
               const std::vector<std::uint8_t>& labels) {
    double cost = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        cost += pieces[i].label[labels[i]];
        if (i > 0 || closed)
            cost += pieces[i].change[labels[i > 0 ? i - 1 : labels.size() - 1]][labels[i]];
    }
    return cost;
}

template <std::size_t Count>
void expect_cheapest_labels(std::size_t most_pieces) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(0, 1);
    for (std::size_t trial = 0; trial < 100; ++trial) {
        std::vector<LabelCosts<Count>> pieces(1 + trial % most_pieces);
        for (LabelCosts<Count>& piece : pieces)
            for (std::size_t from = 0; from < Count; ++from) {
                piece.label[from] = number(random);
                for (std::size_t to = 0; to < Count; ++to)
                    piece.change[from][to] = from == to ? 0 : number(random);
            }
        for (const bool closed : {false, true}) {
            double least = 1e9;
            std::vector<std::uint8_t> labels(pieces.size());
            for (bool is_last = false; !is_last;) {
                least = std::min(least, cost_of(pieces, closed, labels));
                std::size_t i = 0;  // counts on
                while (i < labels.size() && ++labels[i] == Count)
                    labels[i++] = 0;
                is_last = i == labels.size();
            }
            EXPECT_NEAR(cost_of(pieces, closed, cheapest_labels(pieces, closed)), least, 1e-12)
                << trial;
        }
    }
}

/// Against all labellings there are.
TEST(ChainLabels, AreTheCheapestOnes) {
    expect_cheapest_labels<2>(9);
    expect_cheapest_labels<kLayerLabels>(5);
}

LineSet polyline(LineKind kind, const std::vector<Eigen::Vector3f>& points) {
    LineSet lines;
    for (const Eigen::Vector3f& p : points)
        lines.points.push_back({p, 1, 1, 1});
    lines.lines.push_back({0, std::uint32_t(points.size()), kind});
    return lines;
}

TEST(LinePieces, BeginAtPlacesAndCoverTheLine) {
    const LineSet lines =
        polyline(LineKind::Crease, {{0, 0, 0}, {0.1f, 0, 0}, {0.15f, 0, 0}, {3, 0, 0}});
    const auto pieces = pieces_of(lines, lines.lines[0], 0.25, {{1, 0.5}, {2, 0.5}});
    double length = 0;
    int places = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_LE(pieces[i].length, 0.25 + 1e-6);
        const double begin = point_at(lines, lines.lines[0], pieces[i].begin).position.x();
        EXPECT_NEAR(begin, length, 1e-6);
        length += pieces[i].length;
        const LinePlace middle = middle_of(lines, lines.lines[0], pieces[i]);
        EXPECT_NEAR(point_at(lines, lines.lines[0], middle).position.x(),
                    begin + pieces[i].length / 2, 1e-6);
        if (pieces[i].place < 0) continue;
        EXPECT_EQ(pieces[i].place, places++);
        EXPECT_NEAR(begin, pieces[i].place == 0 ? 0.125 : 1.575, 1e-6);
    }
    EXPECT_EQ(places, 2);
    EXPECT_NEAR(length, 3, 1e-6);
}

/// A contour along y before a crease along x, seen from +z: what is right of it is free.
TEST(PictureCrossings, SayWhereAndWhichWayALineMayHide) {
    for (const bool perspective : {false, true}) {
        LineSet lines = polyline(LineKind::Crease, {{-1, 0, 0}, {3, 0, -2}});
        lines.points.push_back({{0.5f, -1, 1}, 1, 1, 1});
        lines.points.push_back({{0.5f, 1, 1}, 1, 1, 1});
        lines.lines.push_back({2, 2, LineKind::Contour});
        const View view =
            perspective ? View::perspective({0.5, 0, 5}) : View::orthographic({0, 0, 1});
        const PictureCrossings crossings(lines, view, {0, 1}, 1);
        ASSERT_TRUE(crossings.are_known());
        const std::vector<Passage> found = crossings.along(lines.lines[0]);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NEAR(point_at(lines, lines.lines[0], found[0].place).position.x(), 0.5, 1e-6);
        EXPECT_FALSE(found[0].may_hide);
        EXPECT_TRUE(found[0].may_show);
        EXPECT_TRUE(crossings.along(lines.lines[1]).empty());  // the contour is nearer
        const PictureCrossings from_behind(lines, View::orthographic({0, 0, -1}), {0, 1}, 1);
        EXPECT_TRUE(from_behind.along(lines.lines[0]).empty());
    }
    const LineSet around = polyline(LineKind::Crease, {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    EXPECT_FALSE(PictureCrossings(around, View::perspective({0, 0.5, 0}), {0}, 1).are_known());
}

Passage passage(double t, bool may_hide, bool may_show, double distance) {
    return {{0, t}, may_hide, may_show, distance};
}

TEST(Layers, ChangeBehindOutlinesThatAreNotTooNear) {
    const LineSet line = polyline(LineKind::Contour, {{0, 0, 0}, {1, 0, 0}});
    const auto steps = [&](const std::vector<Passage>& passages) {
        std::vector<std::array<int, 2>> result;
        for (const LayerStep& step : steps_of(line, line.lines[0], passages, 0.1))
            result.push_back({step.least, step.most});
        return result;
    };
    using Steps = std::vector<std::array<int, 2>>;
    EXPECT_EQ(steps({passage(0.1, true, false, 1), passage(0.3, false, true, 1)}),
              (Steps{{1, 1}, {-1, -1}}));
    EXPECT_EQ(steps({passage(0.1, true, true, 1)}), (Steps{{-1, 1}}));
    EXPECT_EQ(steps({passage(0.1, true, false, 0.05)}), (Steps{{0, 1}}));  // too near
    EXPECT_EQ(steps({passage(0.1, true, false, 1), passage(0.15, false, true, 1),
                     passage(0.2, false, true, 1)}),
              (Steps{{0, 1}, {-1, 0}, {-1, -1}}));  // to and fro
}

/// A contour goes behind an outline, its rays pass that just so, and comes back at a cusp.
TEST(Layers, HideWhatRaysPassBy) {
    const LayerPrices prices = {0.04, 0.001};
    std::vector<LayerCosts> costs;
    for (int i = 0; i < 12; ++i) {
        const LayerStep step = i == 3 ? LayerStep{1, 1} : i == 8 ? LayerStep{-1, 0} : LayerStep{};
        costs.push_back(layer_costs(0.003, 1, step, prices));
    }
    const std::vector<std::uint8_t> labels = cheapest_labels(costs, false);
    for (std::size_t i = 0; i < labels.size(); ++i)
        EXPECT_EQ(labels[i], i >= 3 && i < 8 ? 1 : 0) << i;
    // before an outline from behind which it comes a line is hidden, too
    costs[3] = layer_costs(0.003, 1, {-1, -1}, prices);
    costs[8] = layer_costs(0.003, 1, {}, prices);
    EXPECT_EQ(cheapest_labels(costs, false),
              (std::vector<std::uint8_t>{1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    // of more layers than there are labels for, any may be left
    const LayerCosts fewer = layer_costs(1, 0, {-1, -1}, prices);
    EXPECT_EQ(fewer.change[kLayerLabels - 1][kLayerLabels - 1], 0);
    EXPECT_EQ(fewer.change[kLayerLabels - 1][kLayerLabels - 2], 0);
    EXPECT_GT(fewer.change[1][1], 0);
}

struct Scene {
    TriangleMesh mesh;
    Field field = precompute(mesh);
    LineExtractor extractor{mesh, field};
    LineVisibility visibility{mesh, field};

    LineSet contours(const View& view) const {
        return extract(extractor, view, helpers::all_contours());
    }
};

const View kAslant = View::orthographic({0.45, -0.68, -0.35});

/// Beyond a cusp a contour is behind its own form, however thin the fold is there.
TEST(LineSight, ContoursEndAtCusps) {
    const Scene scene{test_meshes::torus(288, 144).mesh};
    const LineSet all = scene.contours(kAslant);
    const LineSet seen = scene.visibility.visible_parts(kAslant, all);
    const Eigen::Vector3d v = kAslant.eye.normalized();
    int folded = 0, wrong = 0;
    for (const LinePoint& point : all.points) {
        const Eigen::Vector3d p = point.position.cast<double>();
        const double ring = std::hypot(p.x(), p.y()) - 1;
        const auto truth = test_meshes::closed_form_torus_point({}, std::atan2(p.y(), p.x()),
                                                                std::atan2(p.z(), ring));
        if (v.dot(truth.shape_operator * v) > -0.02) continue;
        ++folded;
        wrong += helpers::distance_to_lines(p, seen) < 1e-6;
    }
    EXPECT_GT(folded, 20);
    EXPECT_EQ(wrong, 0);
}

/// The flat base of a jar, seen from its edge, passes other contours by very little.
TEST(LineSight, ContoursHaveNoShortGapsWhereRaysSeeThem) {
    const Scene scene{test_meshes::thrown_vessel()};
    const View front = View::orthographic({0, 0, 1});
    const LineParts parts = scene.visibility.parts(front, scene.contours(front));
    EXPECT_FALSE(parts.seen.lines.empty());
    for (const Polyline& line : parts.hidden.lines)
        EXPECT_GT(line.length, 0.004f) << parts.hidden.points[line.first].position.transpose();
}

TEST(LineSight, DoesNotDependOnWhichSideTrianglesFace) {
    TriangleMesh mesh = test_meshes::torus(144, 72).mesh;
    const Scene outside{mesh};
    test_meshes::flip_triangles(mesh, 1);
    const Scene inside{mesh};
    const auto seen = [](const Scene& scene) {
        return helpers::total_length(
            scene.visibility.visible_parts(kAslant, scene.contours(kAslant)));
    };
    EXPECT_NEAR(seen(inside), seen(outside), 0.02f * seen(outside));
}

/// From behind, a half of a torus shows its inside and its contours there.
TEST(LineSight, ContoursOfOpenSurfacesAreSeenFromInside) {
    const Scene scene{test_meshes::half_torus(144, 72).mesh};
    const View view = View::orthographic({0, -1, 0});  // into the open ends
    const LineSet all = scene.contours(view);
    ASSERT_FALSE(all.lines.empty());
    const LineSet seen = scene.visibility.visible_parts(view, all);
    EXPECT_GT(helpers::total_length(seen), 0.3f * helpers::total_length(all));
}

TEST(LineSight, SeenAndHiddenPartsAreTheWhole) {
    const Scene scene{test_meshes::bumpy_sphere(5).mesh};
    const LineSet all = extract(scene.extractor, kAslant, helpers::all_crossings());
    const LineParts parts = scene.visibility.parts(kAslant, all);
    const float whole = helpers::total_length(all);
    EXPECT_GT(helpers::total_length(parts.hidden), 0.1f * whole);
    EXPECT_NEAR(helpers::total_length(parts.seen) + helpers::total_length(parts.hidden), whole,
                1e-3f * whole);
    EXPECT_TRUE(helpers::same_lines(parts.seen, scene.visibility.visible_parts(kAslant, all)));
}

TEST(LineSight, IsTheSameOnAnyNumberOfThreads) {
    const Scene scene{test_meshes::bumpy_sphere(5).mesh};
    const LineSet all = extract(scene.extractor, kAslant, helpers::all_crossings());
    const int threads = omp_get_max_threads();
    omp_set_num_threads(1);
    const LineParts one = scene.visibility.parts(kAslant, all);
    omp_set_num_threads(3);
    const LineParts three = scene.visibility.parts(kAslant, all);
    omp_set_num_threads(threads);
    EXPECT_TRUE(helpers::same_lines(one.seen, three.seen));
    EXPECT_TRUE(helpers::same_lines(one.hidden, three.hidden));
}

}  // namespace
