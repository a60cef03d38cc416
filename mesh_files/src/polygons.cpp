// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygons.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "text.h"

namespace mesh_files {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

constexpr std::size_t kMostWork = 1000000000;  // seconds

/// Newell's: summed over the edges, twice the area long.
Vector3d normal_of(const std::vector<Vector3d>& polygon) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += (polygon[i] - polygon[0]).cross(polygon[(i + 1) % polygon.size()] - polygon[0]);
    return sum;
}

/// Counter-clockwise, projected. Empty without an area that is a number.
std::vector<Vector2d> in_plane(const std::vector<Vector3d>& polygon) {
    Vector3d sides = Vector3d::Zero();
    for (const Vector3d& p : polygon)
        sides = sides.cwiseMax((p - polygon[0]).cwiseAbs());
    const double size = sides.maxCoeff();
    if (!(size > 0 && size < std::numeric_limits<double>::max())) return {};
    std::vector<Vector3d> scaled;
    for (const Vector3d& p : polygon)
        scaled.push_back((p - polygon[0]) / size);
    const Vector3d normal = normal_of(scaled).stableNormalized();
    if (!(normal.squaredNorm() > 0)) return {};
    const Vector3d right = normal.unitOrthogonal(), up = normal.cross(right);
    std::vector<Vector2d> flat;
    for (const Vector3d& p : scaled)
        flat.emplace_back(right.dot(p), up.dot(p));
    return flat;
}

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
            // Without an ear the polygon crosses itself.
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

}  // namespace

bool triangulate(const std::vector<Vector3d>& positions, const std::uint32_t* corners,
                 std::size_t count, std::size_t& work, std::vector<Triangle>& triangles) {
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        triangles.push_back({corners[a], corners[b], corners[c]});
    };
    std::vector<Vector3d> polygon;
    for (std::size_t i = 0; i < count; ++i)
        polygon.push_back(positions[corners[i]]);
    std::vector<Vector2d> flat = in_plane(polygon);
    if (!flat.empty()) return EarClipping(std::move(flat)).clip(work, add);
    for (std::size_t i = 2; i < count; ++i)
        add(0, i - 1, i);
    return true;
}

std::uint32_t MeshBuilder::vertex(std::int64_t number) const {
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    if (number < 0 || std::uint64_t(number) >= std::min(expected_, most))
        throw Defect{"a face names vertex " + std::to_string(number) + ", counted from 0, of " +
                     std::to_string(std::max(expected_, std::uint64_t(vertex_count())))};
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
