// SPDX-License-Identifier: GPL-3.0-or-later
// Where segments cross in the picture: a tree of boxes finds those near each dividing segment, and
// a crossing is decided by the orientation of the four ends, so that it is there for both or for
// none. Lines in front of the dividing segment are not divided; of two segments with surface on
// both sides, neither is unless they touch.
#include "visibility/visibility_pieces.h"

#include <algorithm>
#include <cmath>

#include "mesh/box_tree.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;
using Box = Eigen::AlignedBox2f;

constexpr double kRounding = 4;  // precisions by which a line may seem in front of its own surface

double twice_area(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
    return std::abs((b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x()));
}

/// Where the line from a to b crosses the line through c and d; a and b are on different sides.
double share_of(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    const double before = twice_area(c, d, a), after = twice_area(c, d, b);
    return before + after > 0 ? before / (before + after) : 0.5;
}

class CrossingFinder {
public:
    explicit CrossingFinder(const VisibilitySegments& all) : all_(all) {
        std::vector<std::uint32_t> dividing;
        Box bounds;
        for (std::uint32_t i = 0; i < all.segments.size(); ++i)
            if (all.segments[i].divides) {
                dividing.push_back(i);
                bounds.extend(box_of(i));
            }
        tree_ = BoxTree<2>::along_curve(std::move(dividing), bounds,
                                        [&](std::uint32_t i) { return box_of(i); });
    }

    std::vector<PictureCrossing> find() const {
        return collect<PictureCrossing>(
            all_.segments.size(),
            [&](std::uint32_t i, std::vector<PictureCrossing>& found) { find_from(i, found); },
            kGrain);
    }

private:
    static constexpr std::size_t kGrain = 512;  // segments

    Box box_of(std::uint32_t segment) const {
        const VisibilitySegment& s = all_.segments[segment];
        const Eigen::Vector2d a = all_.projected(s.points[0]).head<2>(),
                              b = all_.projected(s.points[1]).head<2>();
        return box_outside<2>({a.cwiseMin(b), a.cwiseMax(b)});
    }

    /// Crossings with dividing segments, each pair once.
    void find_from(std::uint32_t i, std::vector<PictureCrossing>& found) const {
        const bool divides = all_.segments[i].divides;
        std::vector<std::uint32_t> others;
        tree_.visit(box_of(i), [&](std::uint32_t k) {
            if (!divides || k > i) others.push_back(k);
        });
        std::sort(others.begin(), others.end());
        for (const std::uint32_t k : others)
            test(i, k, found);
    }

    void test(std::uint32_t i, std::uint32_t k, std::vector<PictureCrossing>& found) const {
        const VisibilitySegment &s = all_.segments[i], &d = all_.segments[k];
        for (const std::uint32_t p : s.points)
            if (p == d.points[0] || p == d.points[1]) return;
        const Vector3d &a = all_.projected(s.points[0]), &b = all_.projected(s.points[1]),
                       &c = all_.projected(d.points[0]), &e = all_.projected(d.points[1]);
        const double room = all_.picture.rise_of(kRounding * all_.picture.mesh().line_precision,
                                                 std::max(a.z(), b.z()));
        // With surface on both sides of each, visibility changes only where they meet in space.
        const bool must_meet = !describe(s.kind).bounds_form && !describe(d.kind).bounds_form;
        if (must_meet && (std::min(a.z(), b.z()) > std::max(c.z(), e.z()) + room ||
                          std::min(c.z(), e.z()) > std::max(a.z(), b.z()) + room))
            return;
        if (Picture::turn(c, e, a) == Picture::turn(c, e, b) ||
            Picture::turn(a, b, c) == Picture::turn(a, b, e))
            return;
        const double t = share_of(a, b, c, e), u = share_of(c, e, a, b);
        const double in_front = a.z() + t * (b.z() - a.z()) - c.z() - u * (e.z() - c.z());
        if (s.edge == VisibilitySegment::kNone && in_front > room) return;
        if (must_meet && std::abs(in_front) > room) return;
        found.push_back({{i, k}, {t, u}});
    }

    const VisibilitySegments& all_;
    BoxTree<2> tree_;  // of dividing segments
};

}  // namespace

std::vector<PictureCrossing> find_crossings(const VisibilitySegments& all) {
    return CrossingFinder(all).find();
}

}  // namespace laplacian_lines
