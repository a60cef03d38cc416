// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

namespace benchmarks {
namespace {

constexpr std::uint32_t kNothing = 0xffffffff;
constexpr double kSeenFromEdge = 0.05;  // pixels: triangles of less height count as seen edge-on
constexpr int kMargin = 2;              // pixels of background all around

/// The interval of x in a triangle at a height of the picture.
std::pair<double, double> span_at(double y, const Eigen::Matrix3d& corners) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (int i = 0; i < 3; ++i) {
        const auto p = corners.col(i), q = corners.col((i + 1) % 3);
        if (std::min(p.y(), q.y()) > y || std::max(p.y(), q.y()) < y) continue;
        const double t = p.y() == q.y() ? 0 : (y - p.y()) / (q.y() - p.y());
        const double x = p.x() + t * (q.x() - p.x());
        left = std::min(left, x);
        right = std::max(right, x);
    }
    return {left, right};
}

}  // namespace

ItemBuffer::ItemBuffer(const laplacian_lines::TriangleMesh& mesh,
                       const line_drawing::ViewFrame& frame)
    : planes_(mesh.triangles.size()) {
    std::vector<Eigen::Vector3d> points;  // pixels, z likewise, towards the viewer
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector3d& p : mesh.positions) {
        const PlanePoint place = kPixelsPerMm * project(p, frame);
        points.emplace_back(place.x(), place.y(), kPixelsPerMm * p.dot(frame.towards_viewer));
        box.extend(place);
    }
    corner_ = box.min() - Eigen::Vector2d(kMargin, kMargin);
    width_ = int(box.sizes().x()) + 2 * kMargin + 2;
    height_ = int(box.sizes().y()) + 2 * kMargin + 2;
    items_.assign(index(0, height_), kNothing);
    depths_.assign(items_.size(), -std::numeric_limits<double>::infinity());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        Eigen::Matrix3d corners;
        for (int i = 0; i < 3; ++i) {
            corners.col(i) = points[mesh.triangles[t][std::size_t(i)]];
            corners.col(i).head<2>() -= corner_;
        }
        fill(t, corners);
    }
}

void ItemBuffer::fill(std::uint32_t item, const Eigen::Matrix3d& c) {
    const Eigen::Vector3d b = c.col(1) - c.col(0), d = c.col(2) - c.col(0);
    const double area = b.x() * d.y() - d.x() * b.y();  // twice
    const double longest =
        std::max({b.head<2>().norm(), d.head<2>().norm(), (d - b).head<2>().norm()});
    const double height = longest > 0 ? std::abs(area) / longest : 0;
    if (height < 1e-6) return;  // pixels; the plane would be noise
    Plane& plane = planes_[item];
    plane.by_x = (b.z() * d.y() - d.z() * b.y()) / area;
    plane.by_y = (d.z() * b.x() - b.z() * d.x()) / area;
    plane.at_origin = c(2, 0) - plane.by_x * c(0, 0) - plane.by_y * c(1, 0);
    plane.is_known = height >= kSeenFromEdge;
    const int last = int(std::floor(c.row(1).maxCoeff()));
    for (int y = int(std::ceil(c.row(1).minCoeff())); y <= last; ++y) {
        const auto [left, right] = span_at(y, c);
        for (int x = int(std::ceil(left)); x <= right; ++x) {
            const std::size_t i = index(x, y);
            if (plane.at(x, y) <= depths_[i]) continue;
            items_[i] = item;
            depths_[i] = plane.at(x, y);
        }
    }
}

/// Calls test(x, y, x2, y2) for pixels of which the second is right of the first or above it;
/// returns the middles between those for which it is true.
template <class Test>
PlaneLine ItemBuffer::between_pixels(Test test) const {
    PlaneLine places;
    for (int y = 0; y + 1 < height_; ++y)
        for (int x = 0; x + 1 < width_; ++x)
            for (const auto& [right, up] : {std::pair{1, 0}, {0, 1}})
                if (test(x, y, x + right, y + up))
                    places.push_back((corner_ + PlanePoint(x + 0.5 * right, y + 0.5 * up)) /
                                     kPixelsPerMm);
    return places;
}

PlaneLine ItemBuffer::border() const {
    return between_pixels([&](int x, int y, int x2, int y2) {
        return (items_[index(x, y)] == kNothing) != (items_[index(x2, y2)] == kNothing);
    });
}

PlaneLine ItemBuffer::jumps(double least) const {
    return between_pixels([&](int x, int y, int x2, int y2) {
        const std::uint32_t item = items_[index(x, y)], item2 = items_[index(x2, y2)];
        if (item == item2 || item == kNothing || item2 == kNothing) return false;
        const Plane &a = planes_[item], &b = planes_[item2];
        if (!a.is_known || !b.is_known) return false;
        const auto [a_far, a_near] = std::minmax({a.at(x, y), a.at(x2, y2)});
        const auto [b_far, b_near] = std::minmax({b.at(x, y), b.at(x2, y2)});
        return std::max(a_far - b_near, b_far - a_near) > least * kPixelsPerMm;
    });
}

PlaneLine bare_places(const PlaneLine& places, const PlaneLines& drawing, double tolerance) {
    const NearSegments near(drawing, tolerance);
    PlaneLine bare;
    for (const PlanePoint& p : places)
        if (!near.has_near(p)) bare.push_back(p);
    return bare;
}

}  // namespace benchmarks
