// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/picture_crossings.h"

#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kNearer = 1e-4;      // in D: an outline that is nearer to the eye by as much hides
constexpr double kLeastDepth = 1e-3;  // of the farthest point; before it there is no picture

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

Vector3d middle_of(const LineSet& lines) {
    Eigen::AlignedBox3d box;
    for (const LinePoint& point : lines.points)
        box.extend(point.position.cast<double>());
    return box.isEmpty() ? Vector3d(Vector3d::Zero()) : Vector3d(box.center());
}

BoxTree::Box box_of(const Vector2d& a, const Vector2d& b) {
    return BoxTree::Box(Vector3d(a.x(), a.y(), 0)).extend(Vector3d(b.x(), b.y(), 0));
}

}  // namespace

/// Finds the outlines that a segment crosses.
class PictureCrossings::Query {
public:
    Query(const PictureCrossings& all, std::uint32_t first, std::uint32_t segment,
          std::vector<Passage>& found)
        : all_(all),
          point_(first + segment),
          segment_(segment),
          begin_(all.places_[point_]),
          way_(all.places_[point_ + 1] - begin_),
          box_(box_of(begin_, all.places_[point_ + 1])),
          found_(found) {}

    bool intersectVolume(const BoxTree::Box& box) const { return box.intersects(box_); }
    bool intersectObject(int number) {
        const Outline& outline = all_.outlines_[std::size_t(number)];
        const Vector2d& a = all_.places_[outline.point];
        const Vector2d way = all_.places_[outline.point + 1] - a;
        const double sine = cross(way_, way);
        if (sine == 0) return false;
        const double t = cross(a - begin_, way) / sine, u = cross(a - begin_, way_) / sine;
        if (!(t >= 0 && t < 1 && u >= 0 && u < 1)) return false;
        const double distance = all_.depth(point_, t) - all_.depth(outline.point, u);
        if (!(distance > all_.nearer_)) return false;
        // the free side is to the right of an outline, where ways of a positive sine lead
        const bool goes_free = outline.free_side * sine > 0;
        const bool knows = outline.free_side != 0;
        found_.push_back({{segment_, all_.share(point_, t)},
                          !knows || !goes_free,
                          !knows || goes_free,
                          distance});
        return false;
    }

private:
    const PictureCrossings& all_;
    const std::uint32_t point_, segment_;
    const Vector2d begin_, way_;
    const BoxTree::Box box_;
    std::vector<Passage>& found_;
};

PictureCrossings::PictureCrossings(const LineSet& lines, const View& view,
                                   const std::vector<int>& free_sides, double diagonal)
    : has_perspective_(view.w != 0), nearer_(kNearer * diagonal) {
    const Vector3d middle = middle_of(lines);
    const Vector3d to_eye = (view.eye - view.w * middle).stableNormalized();
    const Vector3d right = to_eye.unitOrthogonal(), up = to_eye.cross(right);
    double farthest = 0, nearest = 1;
    for (const LinePoint& point : lines.points) {
        const Vector3d p = point.position.cast<double>();
        // from the eye if it is somewhere, else from the middle
        const Vector3d from =
            has_perspective_ ? Vector3d(p - view.eye / view.w) : Vector3d(p - middle);
        const double depth = -to_eye.dot(from), scale = has_perspective_ ? 1 / depth : 1;
        places_.emplace_back(scale * right.dot(from), scale * up.dot(from));
        depths_.push_back(depth);
        farthest = std::max(farthest, depth);
        nearest = std::min(nearest, depth);
    }
    are_known_ = !has_perspective_ || nearest > kLeastDepth * farthest;
    if (!are_known_) return;
    std::vector<BoxTree::Box> boxes;
    for (std::size_t l = 0; l < lines.lines.size(); ++l) {
        const Polyline& line = lines.lines[l];
        if (!describe(line.kind).is_outline) continue;
        for (std::uint32_t i = line.first; i + 1 < line.first + line.count; ++i) {
            outlines_.push_back({i, free_sides[l]});
            boxes.push_back(box_of(places_[i], places_[i + 1]));
        }
    }
    tree_ = BoxTree(boxes, {{}, 0, 1, ""});
}

double PictureCrossings::depth(std::uint32_t point, double t) const {
    const double a = depths_[point], b = depths_[point + 1];
    return has_perspective_ ? 1 / ((1 - t) / a + t / b) : (1 - t) * a + t * b;
}

double PictureCrossings::share(std::uint32_t point, double t) const {
    return has_perspective_ ? t * depth(point, t) / depths_[point + 1] : t;
}

std::vector<Passage> PictureCrossings::along(const Polyline& line) const {
    std::vector<Passage> found;
    if (outlines_.empty()) return found;
    for (std::uint32_t segment = 0; segment + 1 < line.count; ++segment) {
        const std::size_t before = found.size();
        Query query(*this, line.first, segment, found);
        tree_.visit(query);
        std::sort(found.begin() + std::ptrdiff_t(before), found.end(),
                  [](const Passage& a, const Passage& b) { return a.place.t < b.place.t; });
    }
    return found;
}

}  // namespace laplacian_lines
