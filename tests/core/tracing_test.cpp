// SPDX-License-Identifier: GPL-3.0-or-later
// The extractor, with all filters off, against the plain extraction of reference_lines.h on every
// mesh of the registry.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "reference_lines.h"

namespace {

using namespace laplacian_lines;
using test_meshes::MeshEntry;
using test_meshes::TestMesh;

class Tracing : public testing::TestWithParam<const MeshEntry*> {
protected:
    const TestMesh& test_mesh() const { return GetParam()->get(); }
    const TriangleMesh& mesh() const { return GetParam()->get().mesh; }
};

INSTANTIATE_TEST_SUITE_P(Meshes, Tracing, testing::ValuesIn(test_meshes::meshes_with(0)),
                         [](const auto& info) { return info.param->name; });

/// Segments of a line set, looked up by their middle.
class SegmentIndex {
public:
    SegmentIndex(const LineSet& lines, double cell) : cell_(cell) {
        for (const Polyline& line : lines.lines)
            for (std::uint32_t i = line.first; i + 1 < line.first + line.count; ++i) {
                segments_.push_back({lines.points[i].position.cast<double>(),
                                     lines.points[i + 1].position.cast<double>()});
                cells_[key((segments_.back()[0] + segments_.back()[1]) / 2)].push_back(
                    segments_.size() - 1);
            }
        used_.resize(segments_.size(), false);
    }

    /// Finds the segment whose ends are nearest to these, if it is within `tolerance` and was not
    /// taken before.
    bool take(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double tolerance) {
        const Key centre = key((a + b) / 2);
        std::size_t nearest = segments_.size();
        for (int i = 0; i < 27; ++i) {
            const auto found = cells_.find(
                {centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1});
            if (found == cells_.end()) continue;
            for (std::size_t s : found->second) {
                const auto& [p, q] = segments_[s];
                const double distance = std::min(std::max((p - a).norm(), (q - b).norm()),
                                                 std::max((p - b).norm(), (q - a).norm()));
                if (used_[s] || distance > tolerance) continue;
                tolerance = distance;
                nearest = s;
            }
        }
        if (nearest == segments_.size()) return false;
        return used_[nearest] = true;
    }

    std::size_t left() const { return std::size_t(std::count(used_.begin(), used_.end(), false)); }

private:
    using Key = std::array<long, 3>;
    Key key(const Eigen::Vector3d& p) const {
        return {std::lround(p.x() / cell_), std::lround(p.y() / cell_), std::lround(p.z() / cell_)};
    }

    double cell_;
    std::vector<std::array<Eigen::Vector3d, 2>> segments_;
    std::map<Key, std::vector<std::size_t>> cells_;
    std::vector<bool> used_;
};

/// Vertices whose value is so near to zero that its sign depends on rounding.
std::vector<bool> uncertain(const std::vector<double>& values, double part) {
    double largest = 0;
    for (double value : values)
        largest = std::max(largest, std::abs(value));
    std::vector<bool> result;
    for (double value : values)
        result.push_back(std::abs(value) <= part * largest);
    return result;
}

void expect_same_segments(const TriangleMesh& mesh, double diagonal, const LineSet& lines,
                          const std::vector<double>& values) {
    const std::vector<bool> unsure = uncertain(values, 2e-4);
    const auto is_unsure = [&](const Triangle& t) {
        return unsure[t[0]] || unsure[t[1]] || unsure[t[2]];
    };
    SegmentIndex segments(lines, 0.01 * diagonal);
    std::size_t unsure_triangles = 0;
    for (const Triangle& t : mesh.triangles)
        unsure_triangles += is_unsure(t);
    for (const reference::Piece& piece : reference::pieces(mesh, values)) {
        if (is_unsure(mesh.triangles[piece.triangle])) continue;
        EXPECT_TRUE(segments.take(piece.ends[0], piece.ends[1], 5e-4 * diagonal))
            << "missing in triangle " << piece.triangle;
    }
    EXPECT_LE(segments.left(), unsure_triangles);
}

TEST_P(Tracing, FindsEachSegmentOnceFromRandomViews) {
    const Field field = precompute(mesh());
    const LineExtractor extractor(mesh(), field);
    for (const View& view : helpers::random_views(mesh(), 50)) {
        const reference::Values values = reference::evaluate(mesh(), field, view);
        expect_same_segments(mesh(), field.scale.diagonal,
                             helpers::extract(extractor, view, helpers::all_laplacian_lines()),
                             values.laplacian);
        expect_same_segments(mesh(), field.scale.diagonal,
                             helpers::extract(extractor, view, helpers::all_contours()),
                             values.illumination);
        if (HasFailure()) FAIL() << "eye " << view.eye.transpose() << ", w " << view.w;
    }
}

/// A field with ΔI from {−2..2} for the view along z: exact in any order of summation, and zero
/// at every fifth vertex.
Field small_integers(Field field, unsigned seed) {
    std::mt19937 random(seed);
    for (std::size_t v = 0; v < field.normals.size(); ++v) {
        if (field.normals[v].isZero()) continue;
        field.laplacian_normals[v] = {0, 0, float(random() % 5) - 2};
        field.normals[v] = {0, 0, float(random() % 3) - 1};
    }
    return field;
}

TEST_P(Tracing, CountsZeroAsPositive) {
    const Field original = precompute(mesh());
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Field field = small_integers(original, seed);
        const LineExtractor extractor(mesh(), field);
        const View view = View::orthographic(Eigen::Vector3d::UnitZ());
        const reference::Values values = reference::evaluate(mesh(), field, view);
        EXPECT_EQ(
            reference::chains(helpers::extract(extractor, view, helpers::all_laplacian_lines())),
            reference::chains(reference::pieces(mesh(), values.laplacian)));
        EXPECT_EQ(reference::chains(helpers::extract(extractor, view, helpers::all_contours())),
                  reference::chains(reference::pieces(mesh(), values.illumination)));
    }
}

/// Views from which functions vanish at whole rows of vertices.
std::vector<View> axis_views(double distance) {
    std::vector<View> views;
    for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1.0, 1.0}) {
            const Eigen::Vector3d direction = side * Eigen::Vector3d::Unit(axis);
            views.push_back(View::orthographic(direction));
            views.push_back(View::perspective(distance * direction));
        }
    return views;
}

void expect_sound(const LineSet& lines, double diagonal) {
    std::uint32_t next = 0;
    for (const Polyline& line : lines.lines) {
        EXPECT_EQ(line.first, next);  // lines follow each other without gaps
        EXPECT_GE(line.count, 2u);
        next = line.first + line.count;
        ASSERT_LE(next, lines.points.size());
        const LinePoint *begin = &lines.points[line.first], *last = &lines.points[next - 1];
        if (line.closed) {
            EXPECT_EQ(begin->position, last->position);
            EXPECT_EQ(begin->gradient, last->gradient);
            EXPECT_EQ(begin->weight, last->weight);
        }
        double length = 0, strength = 0;
        for (const LinePoint* p = begin; p < last; ++p) {
            const double step = (p[1].position - p[0].position).norm() / diagonal;
            length += step;
            strength += (p[0].gradient + p[1].gradient) / 2 * step;
        }
        EXPECT_NEAR(line.length, length, 1e-4 * length + 1e-5);
        if (line.kind == LineKind::Laplacian || line.kind == LineKind::Contour) {
            EXPECT_NEAR(line.strength, strength, 1e-4 * strength + 1e-4);
        }
    }
    EXPECT_EQ(next, lines.points.size());
    for (const LinePoint& p : lines.points)
        EXPECT_TRUE(p.position.allFinite() && p.gradient >= 0 && p.weight >= 0 && p.weight <= 1);
}

TEST_P(Tracing, LinesAreSoundFromAllViews) {
    const Field field = precompute(mesh());
    const LineExtractor extractor(mesh(), field);
    std::vector<View> views = helpers::random_views(mesh(), 10);
    for (const View& view : axis_views(3 * field.scale.diagonal))
        views.push_back(view);
    LineStyle unsmoothed;  // whose points are the crossings that lengths are measured between
    unsmoothed.line_smoothing = 0;
    for (const View& view : views)
        for (const LineStyle& style : {unsmoothed, helpers::all_crossings()})
            expect_sound(helpers::extract(extractor, view, style), field.scale.diagonal);
}

/// Edges that do not have exactly two triangles, as a line set.
LineSet irregular_edges(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> counts;
    for (const Triangle& t : mesh.triangles) {
        if (!reference::has_area(mesh, t)) continue;
        for (int k = 0; k < 3; ++k)
            ++counts[std::minmax(t[k], t[(k + 1) % 3])];
    }
    LineSet edges;
    for (const auto& [edge, count] : counts) {
        if (count == 2) continue;
        edges.lines.push_back({std::uint32_t(edges.points.size()), 2});
        for (std::uint32_t v : {edge.first, edge.second})
            edges.points.push_back({mesh.positions[v].cast<float>(), 0, 0, 1});
    }
    return edges;
}

/// On a closed surface a level line has no end, wherever zeros fall.
TEST_P(Tracing, EndsLinesOnlyAtBordersAndJunctions) {
    const Field field = precompute(mesh());
    const LineExtractor extractor(mesh(), field);
    const LineSet edges = irregular_edges(mesh());
    EXPECT_EQ(edges.lines.empty(), test_mesh().has(test_meshes::kClosed) ||
                                       test_mesh().name == "flipped_torus" ||
                                       test_mesh().name == "dirty_torus");
    for (const View& view : axis_views(3 * field.scale.diagonal)) {
        const LineSet lines = helpers::extract(extractor, view, helpers::all_crossings());
        for (const Polyline& line : lines.lines)
            for (std::uint32_t end : {line.first, line.first + line.count - 1})
                EXPECT_TRUE(line.closed ||
                            helpers::distance_to_lines(lines.points[end].position.cast<double>(),
                                                       edges) < 1e-5 * field.scale.diagonal);
    }
}

}  // namespace
