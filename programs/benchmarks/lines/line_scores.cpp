// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_scores.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <unordered_map>

namespace benchmarks {

using namespace laplacian_lines;
using test_meshes::ArrisPiece;

namespace {

// Cosine of the angle between an arris and the viewer: arrises on the outline need no line.
constexpr double kLeastFacing = 0.2;

/// In a grid with cells as wide as the distance asked for.
class NearPoints {
public:
    NearPoints(const std::vector<Eigen::Vector3d>& points, double reach) : reach_(reach) {
        for (const Eigen::Vector3d& p : points)
            cells_[key(cell_of(p))].push_back(p);
    }

    bool has(const Eigen::Vector3d& p) const {
        const Cell cell = cell_of(p);
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if (has(cell + Cell(x, y, z), p)) return true;
        return false;
    }

private:
    using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

    bool has(const Cell& cell, const Eigen::Vector3d& p) const {
        const auto found = cells_.find(key(cell));
        if (found == cells_.end()) return false;
        for (const Eigen::Vector3d& q : found->second)
            if ((p - q).squaredNorm() <= reach_ * reach_) return true;
        return false;
    }
    Cell cell_of(const Eigen::Vector3d& p) const {
        return (p / reach_).array().floor().cast<std::int64_t>();
    }
    /// Equal for cells 2^21 apart: `has()` measures.
    static std::uint64_t key(const Cell& c) {
        return (std::uint64_t(c.x() & 0x1fffff) << 42) | (std::uint64_t(c.y() & 0x1fffff) << 21) |
               std::uint64_t(c.z() & 0x1fffff);
    }

    double reach_;
    std::unordered_map<std::uint64_t, std::vector<Eigen::Vector3d>> cells_;
};

}  // namespace

void CurvePoints::add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double step) {
    const double length = (b - a).norm();
    const int count = std::max(1, int(std::ceil(length / step)));
    for (int i = 0; i < count; ++i) {
        points.push_back(a + (i + 0.5) / count * (b - a));
        lengths.push_back(length / count);
    }
}

CurvePoints drawn_points(const LineSet& lines, LineKindSet kinds, double least_opacity,
                         double step) {
    CurvePoints curves;
    for (const Polyline& line : lines.lines) {
        if (!kinds[line.kind]) continue;
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
            const LinePoint &a = lines.points[i - 1], &b = lines.points[i];
            if ((a.opacity + b.opacity) / 2 >= float(least_opacity))
                curves.add(a.position.cast<double>(), b.position.cast<double>(), step);
        }
    }
    return curves;
}

CurvePoints arris_points(const std::vector<ArrisPiece>& arrises, double step) {
    CurvePoints curves;
    for (const ArrisPiece& piece : arrises)
        curves.add(piece.a, piece.b, step);
    return curves;
}

Share& Share::operator+=(const Share& other) {
    part += other.part;
    all += other.all;
    return *this;
}

Share share_near(const CurvePoints& curves, const CurvePoints& others, double reach) {
    const NearPoints near(others.points, reach);
    Share share;
    for (std::size_t i = 0; i < curves.points.size(); ++i) {
        share.all += curves.lengths[i];
        if (near.has(curves.points[i])) share.part += curves.lengths[i];
    }
    return share;
}

double Score::f1() const {
    const double r = recall.value(), p = precision.value();
    return r + p > 0 ? 2 * r * p / (r + p) : 0;
}

Score& Score::operator+=(const Score& other) {
    recall += other.recall;
    precision += other.precision;
    return *this;
}

Score compare(const CurvePoints& drawing, const CurvePoints& right, double reach) {
    return {share_near(right, drawing, reach), share_near(drawing, right, reach)};
}

Truth::Truth(const std::vector<ArrisPiece>& arrises, double sharp_angle, double blunt_angle) {
    for (const ArrisPiece& piece : arrises)
        if (piece.angle >= sharp_angle)
            sharp.push_back(piece);
        else if (piece.angle >= blunt_angle)
            blunt.push_back(piece);
}

Truth Truth::of_side(bool convex) const {
    Truth truth;
    const auto is_of_side = [&](const ArrisPiece& piece) { return piece.convex == convex; };
    std::copy_if(sharp.begin(), sharp.end(), std::back_inserter(truth.sharp), is_of_side);
    std::copy_if(blunt.begin(), blunt.end(), std::back_inserter(truth.blunt), is_of_side);
    return truth;
}

Truth Truth::facing(const Eigen::Vector3d& towards_viewer) const {
    Truth truth;
    truth.blunt = blunt;
    for (const ArrisPiece& piece : sharp)
        (piece.normal.dot(towards_viewer) > kLeastFacing * towards_viewer.norm() ? truth.sharp
                                                                                 : truth.blunt)
            .push_back(piece);
    return truth;
}

Score score(const LineSet& lines, const Truth& truth, LineKindSet kinds, LineKindSet edges,
            const Matching& matching) {
    const double step = matching.step();
    for (const LineKindDescription& row : line_kinds)
        edges[row.kind] = edges[row.kind] && kinds[row.kind];
    const CurvePoints right = arris_points(truth.sharp, step);
    CurvePoints allowed = right;
    for (const ArrisPiece& piece : truth.blunt)
        allowed.add(piece.a, piece.b, step);
    return {
        share_near(right, drawn_points(lines, kinds, matching.least_opacity, step), matching.reach),
        share_near(drawn_points(lines, edges, matching.least_opacity, step), allowed,
                   matching.reach)};
}

}  // namespace benchmarks
