// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace benchmarks {

using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

namespace {

// Below this area, in square pixels, the shares of corners are nothing but rounding.
constexpr double kLeastArea = 1e-9;
// So that rounding leaves no gap between neighbours.
constexpr double kTolerance = 1e-9;

/// A triangle on the picture; the third coordinate is the affine depth.
class FlatTriangle {
public:
    FlatTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
        : a_(a), b_(b), c_(c), area_(twice_area(a, b, c.x(), c.y())) {}

    bool has_area() const { return std::abs(area_) > kLeastArea; }
    /// The shares of the corners in a place; all positive inside.
    Eigen::Vector3d shares(double x, double y) const {
        return Eigen::Vector3d(twice_area(b_, c_, x, y), twice_area(c_, a_, x, y),
                               twice_area(a_, b_, x, y)) /
               area_;
    }
    double depth(const Eigen::Vector3d& shares) const {
        return shares.dot(Eigen::Vector3d(a_.z(), b_.z(), c_.z()));
    }

private:
    static double twice_area(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double x,
                             double y) {
        return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
    }

    const Eigen::Vector3d &a_, &b_, &c_;
    double area_;
};

/// First and last pixel of the picture with a middle between two numbers.
std::pair<int, int> middles_between(double low, double high, int size) {
    const auto pixel = [&](double x) { return int(std::clamp(x, -1.0, double(size))); };
    return {std::max(0, pixel(std::ceil(low - 0.5))),
            std::min(size - 1, pixel(std::floor(high - 0.5)))};
}

}  // namespace

DepthPicture::DepthPicture(const PictureCamera& camera, const TriangleMesh& mesh)
    : camera_(camera),
      mesh_(mesh),
      places_(mesh.positions.size()),
      triangles_(std::size_t(size()) * std::size_t(size()), -1),
      depths_(triangles_.size(), std::numeric_limits<double>::infinity()) {
    for (std::size_t v = 0; v < places_.size(); ++v) {
        places_[v] = camera.project(mesh.positions[v]);
        places_[v].z() = camera.affine_depth(places_[v].z());
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        draw(std::int32_t(t));
}

void DepthPicture::draw(std::int32_t triangle) {
    const Triangle& t = mesh_.triangles[std::size_t(triangle)];
    const Eigen::Vector3d &a = places_[t[0]], &b = places_[t[1]], &c = places_[t[2]];
    const FlatTriangle flat(a, b, c);
    if (!flat.has_area()) return;
    const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const auto [left, right] = middles_between(low.x(), high.x(), size());
    const auto [top, bottom] = middles_between(low.y(), high.y(), size());
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x) {
            const Eigen::Vector3d shares = flat.shares(x + 0.5, y + 0.5);
            if (shares.minCoeff() < -kTolerance) continue;
            const double depth = flat.depth(shares);
            if (!(depth < depths_[index(x, y)])) continue;
            depths_[index(x, y)] = depth;
            triangles_[index(x, y)] = triangle;
        }
}

std::int32_t DepthPicture::triangle_at(int x, int y) const {
    return x >= 0 && y >= 0 && x < size() && y < size() ? triangles_[index(x, y)] : -1;
}

double DepthPicture::depth_at(int x, int y) const {
    return is_surface(x, y) ? camera_.true_depth(depths_[index(x, y)])
                            : std::numeric_limits<double>::infinity();
}

double DepthPicture::plane_depth(std::int32_t triangle, double column, double row) const {
    const Triangle& t = mesh_.triangles[std::size_t(triangle)];
    const FlatTriangle flat(places_[t[0]], places_[t[1]], places_[t[2]]);
    return camera_.true_depth(flat.depth(flat.shares(column, row)));
}

Eigen::Vector3d DepthPicture::normal_to_eye(std::int32_t triangle) const {
    const Triangle& t = mesh_.triangles[std::size_t(triangle)];
    const Eigen::Vector3d &a = mesh_.positions[t[0]], &b = mesh_.positions[t[1]],
                          &c = mesh_.positions[t[2]];
    const Eigen::Vector3d n = (b - a).cross(c - a).normalized();
    const laplacian_lines::View& view = camera_.view();
    return n.dot(view.eye - view.w * a) < 0 ? Eigen::Vector3d(-n) : n;
}

PixelMask DepthPicture::outline() const {
    PixelMask mask(size());
    for (int y = 0; y < size(); ++y)
        for (int x = 0; x < size(); ++x)
            if (is_surface(x, y) && !(is_surface(x - 1, y) && is_surface(x + 1, y) &&
                                      is_surface(x, y - 1) && is_surface(x, y + 1)))
                mask.set(x, y);
    return mask;
}

template <class Differ>
PixelMask DepthPicture::jumps(Differ differ) const {
    PixelMask mask(size());
    const auto compare = [&](int x, int y, int other_x, int other_y) {
        const std::int32_t t = triangle_at(x, y), other = triangle_at(other_x, other_y);
        if (t < 0 || other < 0 || t == other || !differ(x, y, other_x, other_y)) return;
        mask.set(x, y);
        mask.set(other_x, other_y);
    };
    for (int y = 0; y < size(); ++y)
        for (int x = 0; x < size(); ++x) {
            compare(x, y, x + 1, y);
            compare(x, y, x, y + 1);
        }
    return mask;
}

PixelMask DepthPicture::depth_jumps(double depth) const {
    const auto misses = [&](int x, int y, int other_x, int other_y) {
        const double continued = plane_depth(triangle_at(x, y), other_x + 0.5, other_y + 0.5);
        return std::abs(continued - depth_at(other_x, other_y)) > depth;
    };
    return jumps([&](int x, int y, int other_x, int other_y) {
        return misses(x, y, other_x, other_y) && misses(other_x, other_y, x, y);
    });
}

PixelMask DepthPicture::normal_jumps(double degrees) const {
    const double least_cosine = std::cos(degrees * std::acos(-1.0) / 180);
    return jumps([&](int x, int y, int other_x, int other_y) {
        return normal_to_eye(triangle_at(x, y)).dot(normal_to_eye(triangle_at(other_x, other_y))) <
               least_cosine;
    });
}

}  // namespace benchmarks
