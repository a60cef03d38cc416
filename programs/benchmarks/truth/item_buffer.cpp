// SPDX-License-Identifier: GPL-3.0-or-later
#include "item_buffer.h"

#include <limits>
#include <stdexcept>
#include <utility>

#include "plane_lines.h"

namespace benchmarks {
namespace {

using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

constexpr double most_pixels = 1e8;
constexpr double seen_from_edge = 0.05;  // pixels, of the height of a triangle
constexpr int margin = 2;                // pixels of background all around
constexpr double near_line = 0.15, far_line = 0.8, least_jump = 0.5;  // mm

bool is_finite(const TriangleMesh& mesh, const Triangle& triangle) {
    for (const std::uint32_t v : triangle)
        if (!mesh.positions[v].allFinite()) return false;
    return true;
}

/// Twice the area, in the picture.
double area_of(const Eigen::Matrix3d& corners) {
    const Eigen::Vector3d b = corners.col(1) - corners.col(0), c = corners.col(2) - corners.col(0);
    return b.x() * c.y() - b.y() * c.x();
}

/// Over the longest side, in the picture.
double height_of(const Eigen::Matrix3d& corners) {
    double longest = 0;
    for (int i = 0; i < 3; ++i)
        longest = std::max(longest, (corners.col(i) - corners.col((i + 1) % 3)).head<2>().norm());
    return longest > 0 ? std::abs(area_of(corners)) / longest : 0;
}

/// Of a triangle at a height of the picture.
std::pair<double, double> span_at(double y, const Eigen::Matrix3d& corners) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    const auto reach = [&](double x) {
        left = std::min(left, x);
        right = std::max(right, x);
    };
    for (int i = 0; i < 3; ++i) {
        const auto p = corners.col(i), q = corners.col((i + 1) % 3);
        if (std::min(p.y(), q.y()) > y || std::max(p.y(), q.y()) < y) continue;
        if (p.y() == q.y()) {
            reach(p.x());
            reach(q.x());
        } else {
            reach(p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x()));
        }
    }
    return {left, right};
}

}  // namespace

ItemBuffer::ItemBuffer(const TriangleMesh& mesh, const PlaneFrame& frame,
                       const DrawingSetup& setup) {
    const double scale = setup.mm_per_unit * item_pixels_per_mm;
    std::vector<Eigen::Vector3d> points;  // pixels, z likewise, towards the viewer
    for (const Eigen::Vector3d& p : mesh.positions) {
        const Eigen::Vector3d q = p - setup.origin;
        points.push_back(scale *
                         Eigen::Vector3d(q.dot(frame.right), q.dot(frame.up), q.dot(frame.viewer)));
    }
    Eigen::AlignedBox2d box;
    for (const Triangle& triangle : mesh.triangles)
        if (is_finite(mesh, triangle))
            for (const std::uint32_t v : triangle)
                box.extend(points[v].head<2>());
    if (box.isEmpty()) return;
    const Eigen::Vector2d size = box.sizes().array().ceil() + 2 * margin + 1;
    if (!(size.prod() < most_pixels))
        throw std::runtime_error("the mesh is too large to be filled");
    corner_ = box.min() - Eigen::Vector2d(margin, margin);
    width_ = int(size.x());
    height_ = int(size.y());
    items_.assign(std::size_t(size.prod()), nothing);
    depths_.assign(items_.size(), -std::numeric_limits<float>::infinity());
    planes_.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!is_finite(mesh, mesh.triangles[t])) continue;
        Eigen::Matrix3d corners;
        for (int i = 0; i < 3; ++i) {
            corners.col(i) = points[mesh.triangles[t][std::size_t(i)]];
            corners.col(i).head<2>() -= corner_;
        }
        fill(t, corners);
    }
}

PlanePoint ItemBuffer::place(double x, double y) const {
    return (corner_ + Eigen::Vector2d(x, y)) / item_pixels_per_mm;
}

std::optional<double> ItemBuffer::depth_at(const PlanePoint& place) const {
    const PlanePoint pixel = item_pixels_per_mm * place - corner_;
    const int x = int(std::lround(pixel.x())), y = int(std::lround(pixel.y()));
    if (x < 0 || y < 0 || x >= width_ || y >= height_ || !is_covered(x, y)) return {};
    return double(depths_[index(x, y)]) / item_pixels_per_mm;
}

void ItemBuffer::cover(std::uint32_t item, int x, int y, double depth) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    const std::size_t i = index(x, y);
    if (items_[i] != nothing && float(depth) <= depths_[i]) return;
    items_[i] = item;
    depths_[i] = float(depth);
}

/// Triangles seen edge-on are traced: they would fall between pixel centres.
void ItemBuffer::fill(std::uint32_t item, const Eigen::Matrix3d& c) {
    const double height = height_of(c);
    if (height < seen_from_edge)
        for (int i = 0; i < 3; ++i)
            trace(item, c.col(i), c.col((i + 1) % 3));
    if (height < 1e-6) return;
    const double area = area_of(c);
    const Eigen::Vector3d b = c.col(1) - c.col(0), d = c.col(2) - c.col(0);
    Plane& plane = planes_[item];
    plane.by_x = (b.z() * d.y() - d.z() * b.y()) / area;
    plane.by_y = (d.z() * b.x() - b.z() * d.x()) / area;
    plane.is_known = height >= seen_from_edge;
    plane.at_origin = c(2, 0) - plane.by_x * c(0, 0) - plane.by_y * c(1, 0);
    const int first = std::max(0, int(std::ceil(c.row(1).minCoeff())));
    const int last = std::min(height_ - 1, int(std::floor(c.row(1).maxCoeff())));
    for (int y = first; y <= last; ++y) {
        const auto [left, right] = span_at(y, c);
        for (int x = int(std::ceil(left)); x <= right; ++x)
            cover(item, x, y, plane.at(x, y));
    }
}

void ItemBuffer::trace(std::uint32_t item, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const int count = 1 + int(2 * (b - a).head<2>().norm());
    for (int k = 0; k <= count; ++k) {
        const Eigen::Vector3d p = a + (b - a) * (double(k) / count);
        cover(item, int(std::lround(p.x())), int(std::lround(p.y())), p.z());
    }
}

template <class Test>
PlaneLine ItemBuffer::between_pixels(Test test) const {
    PlaneLine places;
    for (int y = 0; y + 1 < height_; ++y)
        for (int x = 0; x + 1 < width_; ++x) {
            if (test(x, y, 1, 0)) places.push_back(place(x + 0.5, y));
            if (test(x, y, 0, 1)) places.push_back(place(x, y + 0.5));
        }
    return places;
}

PlaneLine ItemBuffer::border() const {
    return between_pixels([&](int x, int y, int right, int up) {
        return is_covered(x, y) != is_covered(x + right, y + up);
    });
}

/// The surfaces of the two pixels do not meet between them.
bool ItemBuffer::is_jump(int x, int y, int right, int up, double least) const {
    const int x2 = x + right, y2 = y + up;
    const std::uint32_t a = items_[index(x, y)], b = items_[index(x2, y2)];
    if (a == b || a == nothing || b == nothing) return false;
    if (!planes_[a].is_known || !planes_[b].is_known) return false;
    const double a1 = planes_[a].at(x, y), a2 = planes_[a].at(x2, y2);
    const double b1 = planes_[b].at(x, y), b2 = planes_[b].at(x2, y2);
    const double gap =
        std::max(std::min(a1, a2) - std::max(b1, b2), std::min(b1, b2) - std::max(a1, a2));
    return gap > least * item_pixels_per_mm;
}

PlaneLine ItemBuffer::jumps(double least) const {
    return between_pixels(
        [&](int x, int y, int right, int up) { return is_jump(x, y, right, up, least); });
}

void SilhouetteScores::add(const SilhouetteScores& other) {
    border += other.border;
    bare_border += other.bare_border;
    far_border += other.far_border;
    jumps += other.jumps;
    bare_jumps += other.bare_jumps;
}

SilhouetteScores score_silhouette(const ItemBuffer& items, const DrawnPaths& drawing,
                                  BarePlaces* bare) {
    const PlaneLines lines = lines_of(drawing);
    const NearSegments near(lines, near_line), far(lines, far_line);
    const auto has_line = [](const NearSegments& segments, const PlanePoint& p) {
        return segments.any_near(p, [](const NearPlace&) { return true; });
    };
    SilhouetteScores scores;
    for (const PlanePoint& p : items.border()) {
        ++scores.border;
        if (has_line(near, p)) continue;
        ++scores.bare_border;
        scores.far_border += !has_line(far, p);
        if (bare) bare->border.push_back(p);
    }
    for (const PlanePoint& p : items.jumps(least_jump)) {
        ++scores.jumps;
        if (has_line(near, p)) continue;
        ++scores.bare_jumps;
        if (bare) bare->jumps.push_back(p);
    }
    return scores;
}

}  // namespace benchmarks
