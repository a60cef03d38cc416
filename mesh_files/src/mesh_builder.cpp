// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of any number of corners become triangles, once all vertices are read: flat ones, and those
// of many corners, by cutting off ears, others by the triangulation of least area.
#include "mesh_builder.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "text.h"

namespace mesh_files {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

constexpr std::size_t kMostWork = 1000000000;  // corners visited: some seconds
constexpr double kPlanar = 1e-6;               // of the size; as far as coordinates are rounded
constexpr std::size_t kMostLeastArea = 32;     // corners: the work grows with their cube
constexpr double kFolded = 1000;               // factor of the area of folded triangles

/// By Newell's sum over the edges; twice the area long.
Vector3d normal_of(const std::vector<Vector3d>& polygon) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += (polygon[i] - polygon[0]).cross(polygon[(i + 1) % polygon.size()] - polygon[0]);
    return sum;
}

/// The polygon scaled to size 1, relative to its first corner. Empty if its size is 0 or infinite.
std::vector<Vector3d> scaled(const std::vector<Vector3d>& polygon) {
    Vector3d sides = Vector3d::Zero();
    for (const Vector3d& p : polygon)
        sides = sides.cwiseMax((p - polygon[0]).cwiseAbs());
    const double size = sides.maxCoeff();
    if (!(size > 0 && size < std::numeric_limits<double>::max())) return {};
    std::vector<Vector3d> all;
    for (const Vector3d& p : polygon)
        all.push_back((p - polygon[0]) / size);
    return all;
}

/// Projected along the normal, counter-clockwise.
std::vector<Vector2d> in_plane(const std::vector<Vector3d>& polygon, const Vector3d& normal) {
    const Vector3d right = normal.unitOrthogonal(), up = normal.cross(right);
    std::vector<Vector2d> flat;
    for (const Vector3d& p : polygon)
        flat.emplace_back(right.dot(p), up.dot(p));
    return flat;
}

bool is_planar(const std::vector<Vector3d>& polygon, const Vector3d& normal) {
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](const Vector3d& p) { return std::abs(normal.dot(p)) < kPlanar; });
}

/// Triangulates a polygon with the least total area, in which triangles that are folded back count
/// more, by dynamic programming (Klincsek 1980).
class LeastArea {
public:
    LeastArea(const std::vector<Vector3d>& polygon, const Vector3d& normal)
        : polygon_(polygon), normal_(normal), best_(polygon.size() * polygon.size()) {
        for (std::size_t length = 2; length < polygon.size(); ++length)
            for (std::size_t a = 0; a + length < polygon.size(); ++a)
                choose(a, a + length);
    }

    template <class Add>
    void cut(std::size_t a, std::size_t c, Add add) const {
        if (c < a + 2) return;
        const std::size_t b = best(a, c).tip;
        cut(a, b, add);
        cut(b, c, add);
        add(a, b, c);
    }

private:
    struct Best {
        double cost = 0;
        std::size_t tip = 0;
    };

    const Best& best(std::size_t a, std::size_t c) const { return best_[a * polygon_.size() + c]; }

    void choose(std::size_t a, std::size_t c) {
        Best& found = best_[a * polygon_.size() + c];
        found.cost = std::numeric_limits<double>::infinity();
        for (std::size_t b = a + 1; b < c; ++b) {
            const double cost = best(a, b).cost + best(b, c).cost + cost_of(a, b, c);
            if (cost < found.cost) found = {cost, b};
        }
    }

    double cost_of(std::size_t a, std::size_t b, std::size_t c) const {
        const Vector3d twice = (polygon_[b] - polygon_[a]).cross(polygon_[c] - polygon_[a]);
        return twice.norm() * (twice.dot(normal_) < 0 ? kFolded : 1);
    }

    const std::vector<Vector3d>& polygon_;
    const Vector3d normal_;
    std::vector<Best> best_;  // by first and last corner
};

/// Twice the area, positive if counter-clockwise.
double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

class EarClipping {
public:
    explicit EarClipping(std::vector<Vector2d> flat) : flat_(std::move(flat)) {
        const std::size_t n = flat_.size();
        for (std::size_t i = 0; i < n; ++i) {
            next_.push_back((i + 1) % n);
            before_.push_back((i + n - 1) % n);
        }
        for (std::size_t i = 0; i < n; ++i)
            if (turn_at(i) <= 0) reflex_.push_back(i);
    }

    /// Calls add(a, b, c) for each triangle. False if `work` ran out.
    template <class Add>
    bool clip(std::size_t& work, Add add) {
        std::size_t left = flat_.size(), at = 0, tried = 0;
        while (left > 3) {
            if (work < reflex_.size() + 1) return false;
            work -= reflex_.size() + 1;
            // What has no ear crosses itself, or has no area.
            if (is_ear(at) || tried > left) {
                add(before_[at], at, next_[at]);
                at = cut_off(at);
                --left;
                tried = 0;
            } else {
                at = next_[at];
                ++tried;
            }
        }
        add(before_[at], at, next_[at]);
        return true;
    }

private:
    double turn_at(std::size_t i) const {
        return turn(flat_[before_[i]], flat_[i], flat_[next_[i]]);
    }

    bool is_ear(std::size_t i) const {
        const Vector2d &a = flat_[before_[i]], &b = flat_[i], &c = flat_[next_[i]];
        if (turn(a, b, c) <= 0) return false;
        return std::none_of(reflex_.begin(), reflex_.end(), [&](std::size_t k) {
            const Vector2d& p = flat_[k];
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
                   turn(c, a, p) >= 0;
        });
    }

    std::size_t cut_off(std::size_t i) {
        const std::size_t a = before_[i], c = next_[i];
        next_[a] = c;
        before_[c] = a;
        reflex_.erase(std::remove_if(reflex_.begin(), reflex_.end(),
                                     [&](std::size_t k) {
                                         return k == i || ((k == a || k == c) && turn_at(k) > 0);
                                     }),
                      reflex_.end());
        return c;
    }

    const std::vector<Vector2d> flat_;
    std::vector<std::size_t> next_, before_, reflex_;
};

/// Triangulates a polygon by ear clipping (Meisters 1975); the result is arbitrary if it crosses
/// itself. Polygons that are not planar, unless they have many corners, get the triangles of least
/// area. `work`: how many corners may still be visited; false if it ran out.
bool triangulate(const std::vector<Vector3d>& positions, const std::uint32_t* corners,
                 std::size_t count, std::size_t& work, std::vector<Triangle>& triangles) {
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        triangles.push_back({corners[a], corners[b], corners[c]});
    };
    std::vector<Vector3d> polygon;
    for (std::size_t i = 0; i < count; ++i)
        polygon.push_back(positions[corners[i]]);
    polygon = scaled(polygon);
    const Vector3d normal =
        polygon.empty() ? Vector3d::Zero() : normal_of(polygon).stableNormalized().eval();
    if (!(normal.squaredNorm() > 0)) {
        for (std::size_t i = 2; i < count; ++i)
            add(0, i - 1, i);
        return true;
    }
    if (count > kMostLeastArea || is_planar(polygon, normal))
        return EarClipping(in_plane(polygon, normal)).clip(work, add);
    LeastArea(polygon, normal).cut(0, count - 1, add);
    return true;
}

}  // namespace

std::uint32_t MeshBuilder::vertex(std::int64_t number) const {
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    if (number < 0 || std::uint64_t(number) >= std::min(expected_, most))
        throw Defect{"a face names vertex " + std::to_string(number) + ", counted from 0, of " +
                     std::to_string(expected_)};
    return std::uint32_t(number);
}

void MeshBuilder::add_triangle(std::int64_t a, std::int64_t b, std::int64_t c) {
    mesh_.triangles.push_back({vertex(a), vertex(b), vertex(c)});
}

void MeshBuilder::add(const std::vector<std::int64_t>& corners) {
    if (corners.size() < 3) {
        ++skipped_faces_;
        return;
    }
    if (corners.size() == 3) return add_triangle(corners[0], corners[1], corners[2]);
    for (const std::int64_t corner : corners)
        corners_.push_back(vertex(corner));
    ends_.push_back(corners_.size());
}

TriangleMesh MeshBuilder::finish(std::string& defect) {
    const auto is_there = [&](std::uint32_t corner) { return corner < mesh_.positions.size(); };
    const auto is_missing = [&](const Triangle& t) {
        return !std::all_of(t.begin(), t.end(), is_there);
    };
    mesh_.triangles.erase(
        std::remove_if(mesh_.triangles.begin(), mesh_.triangles.end(), is_missing),
        mesh_.triangles.end());
    std::size_t begin = 0, work = kMostWork;
    for (const std::size_t end : ends_) {
        const std::uint32_t* corners = corners_.data() + begin;
        if (std::all_of(corners, corners + (end - begin), is_there) &&
            !triangulate(mesh_.positions, corners, end - begin, work, mesh_.triangles)) {
            if (defect.empty())
                defect = "a face of " + std::to_string(end - begin) +
                         " corners is too intricate; make triangles of it first";
            break;
        }
        begin = end;
    }
    return std::move(mesh_);
}

}  // namespace mesh_files
