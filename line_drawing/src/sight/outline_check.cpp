// SPDX-License-Identifier: GPL-3.0-or-later
#include "sight/observer.h"

#include <algorithm>
#include <cmath>

namespace line_drawing {
namespace {

using Eigen::Vector2d;
using laplacian_lines::TriangleMesh;

constexpr double most_pixels = 4096;  // along a side
constexpr int reach = 2;              // pixels

class Mask {
public:
    Mask(const Eigen::AlignedBox2d& box, double pixel)
        : pixel_(std::max(pixel, box.sizes().maxCoeff() / most_pixels)),
          low_(box.min() - Vector2d::Constant((reach + 1) * pixel_)),
          width_(std::size_t(std::ceil(box.sizes().x() / pixel_)) + 2 * reach + 3),
          height_(std::size_t(std::ceil(box.sizes().y() / pixel_)) + 2 * reach + 3),
          is_set_(width_ * height_) {}

    Vector2d inPixels(const Vector2d& p) const { return (p - low_) / pixel_; }
    Vector2d middleOf(std::size_t x, std::size_t y) const {
        return low_ + pixel_ * Vector2d(double(x) + 0.5, double(y) + 0.5);
    }
    std::size_t width() const { return width_; }
    std::size_t height() const { return height_; }
    bool isSet(std::size_t x, std::size_t y) const { return is_set_[y * width_ + x] != 0; }

    void clear() { std::fill(is_set_.begin(), is_set_.end(), 0); }

    void fill(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
        const double low = std::min({a.y(), b.y(), c.y()}), high = std::max({a.y(), b.y(), c.y()});
        for (double y = std::ceil(low - 0.5); y + 0.5 <= high; ++y) {
            double begin = INFINITY, end = -INFINITY;
            for (const auto& [from, to] :
                 {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
                if ((from->y() <= y + 0.5) == (to->y() <= y + 0.5)) continue;
                const double t = (y + 0.5 - from->y()) / (to->y() - from->y());
                const double x = from->x() + t * (to->x() - from->x());
                begin = std::min(begin, x);
                end = std::max(end, x);
            }
            for (double x = std::max(0., std::ceil(begin - 0.5)); x + 0.5 <= end; ++x)
                set(x, y);
        }
    }

    void draw(const Vector2d& from, const Vector2d& to) {
        const double steps = std::max(1., std::ceil((to - from).norm()));
        for (double i = 0; i <= steps; ++i) {
            const Vector2d p = from + i / steps * (to - from);
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx)
                    set(std::floor(p.x()) + dx, std::floor(p.y()) + dy);
        }
    }

private:
    void set(double x, double y) {
        if (x >= 0 && y >= 0 && x < double(width_) && y < double(height_))
            is_set_[std::size_t(y) * width_ + std::size_t(x)] = 1;
    }

    const double pixel_;
    const Vector2d low_;
    const std::size_t width_, height_;
    std::vector<char> is_set_;
};

Mask coverOf(const TriangleMesh& mesh, const Projection& projection, double unit,
             const Eigen::AlignedBox2d& bounds, double pixel) {
    Mask cover(bounds.isEmpty() ? Eigen::AlignedBox2d(Vector2d(0, 0)) : bounds, pixel);
    std::vector<Vector2d> places;  // in pixels; not finite where vertices are not
    places.reserve(mesh.positions.size());
    for (const Eigen::Vector3d& p : mesh.positions)
        places.push_back(cover.inPixels(unit * projection(p)));
    for (const laplacian_lines::Triangle& t : mesh.triangles) {
        const Vector2d &a = places[t[0]], &b = places[t[1]], &c = places[t[2]];
        if (std::isfinite(a.sum() + b.sum() + c.sum())) cover.fill(a, b, c);
    }
    return cover;
}

bool isAtBorder(const Mask& cover, std::size_t x, std::size_t y) {
    return cover.isSet(x, y) && (!cover.isSet(x - 1, y) || !cover.isSet(x + 1, y) ||
                                 !cover.isSet(x, y - 1) || !cover.isSet(x, y + 1));
}

}  // namespace

std::vector<Vector2d> borderWithoutOutline(const TriangleMesh& mesh, const Projection& projection,
                                           double unit, const Eigen::AlignedBox2d& bounds,
                                           const std::vector<DrawnLine>& lines, double pixel) {
    const Mask cover = coverOf(mesh, projection, unit, bounds, pixel);
    Mask outlines = cover;
    outlines.clear();
    for (const DrawnLine& line : lines)
        if (line.line_class == LineClass::Outline)
            for (std::size_t i = 1; i < line.points.size(); ++i)
                outlines.draw(outlines.inPixels(line.points[i - 1].position),
                              outlines.inPixels(line.points[i].position));
    std::vector<Vector2d> missing;
    for (std::size_t y = 1; y + 1 < cover.height(); ++y)
        for (std::size_t x = 1; x + 1 < cover.width(); ++x)
            if (isAtBorder(cover, x, y) && !outlines.isSet(x, y))
                missing.push_back(cover.middleOf(x, y));
    return missing;
}

std::vector<DrawnLine> linesAt(const std::vector<Vector2d>& places,
                               const std::vector<DrawnLine>& lines, double pixel) {
    std::vector<DrawnLine> found;
    for (const DrawnLine& line : lines)
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const Vector2d &a = line.points[i - 1].position, &b = line.points[i].position;
            const double squared = (b - a).squaredNorm();
            const auto is_near = [&](const Vector2d& p) {
                const double t = squared > 0 ? std::clamp((b - a).dot(p - a) / squared, 0., 1.) : 0;
                return (a + t * (b - a) - p).norm() <= (reach + 1) * pixel;
            };
            if (std::any_of(places.begin(), places.end(), is_near))
                found.push_back({LineClass::Outline, false, {{a}, {b}}});
        }
    return found;
}

}  // namespace line_drawing
