// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_ends.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

namespace benchmarks {
namespace {

using namespace laplacian_lines;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// x and y in the picture, z towards the eye.
using Places = std::vector<Vector3d>;

class Picture {
public:
    Picture(const LineSet& lines, const View& view) : lines_(lines) {
        Eigen::Matrix3d axes;
        axes.row(2) = view.eye.normalized();
        axes.row(0) = axes.row(2).unitOrthogonal();
        axes.row(1) = axes.row(2).cross(axes.row(0));
        for (const LinePoint& point : lines.points)
            points.push_back(axes * point.position.cast<double>());
    }
    Places along(const Polyline& line) const {
        return {points.begin() + line.first, points.begin() + line.first + line.count};
    }
    const LineSet& lines() const { return lines_; }

    Places points;

private:
    const LineSet& lines_;
};

Vector2d flat(const Vector3d& p) {
    return p.head<2>();
}

/// The place of a segment nearest to p in the picture.
Vector3d nearest(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
    const Vector2d way = flat(b - a);
    const double square = way.squaredNorm();
    const double t = square > 0 ? std::clamp(flat(p - a).dot(way) / square, 0., 1.) : 0;
    return a + t * (b - a);
}

bool is_outline(const Polyline& line) {
    return describe(line.kind).is_outline;
}

bool crosses_a_nearer_outline(const Vector3d& end, const Picture& seen, double reach) {
    for (const Polyline& line : seen.lines().lines)
        for (std::uint32_t i = line.first; is_outline(line) && i + 1 < line.first + line.count;
             ++i) {
            const Vector3d q = nearest(seen.points[i], seen.points[i + 1], end);
            if (flat(q - end).norm() < reach && q.z() > end.z() + reach) return true;
        }
    return false;
}

/// Where on which line an end is.
struct Origin {
    const Polyline* line = nullptr;
    std::uint32_t segment = 0;
    double distance = std::numeric_limits<double>::infinity();
};

Origin origin_of(const Vector3d& end, const Picture& whole) {
    Origin best;
    for (const Polyline& line : whole.lines().lines)
        for (std::uint32_t i = 0; line.kind == LineKind::Contour && i + 1 < line.count; ++i) {
            const Vector3d &a = whole.points[line.first + i], &b = whole.points[line.first + i + 1];
            const double square = (b - a).squaredNorm();
            const double t = square > 0 ? std::clamp((end - a).dot(b - a) / square, 0., 1.) : 0;
            const double distance = (a + t * (b - a) - end).norm();
            if (distance < best.distance) best = {&line, i, distance};
        }
    return best;
}

/// The course of a line in the picture, from a place on, as far as `reach` of its own length.
Places course(const Places& line, bool closed, std::size_t from, int step, double reach) {
    Places result = {line[from]};
    const std::size_t count = closed ? line.size() - 1 : line.size();
    for (double length = 0; length < reach && result.size() <= count;) {
        if (!closed && (step > 0 ? from + 1 == count : from == 0)) break;
        from = (from + count + std::size_t(step)) % count;
        length += flat(line[from] - result.back()).norm();
        result.push_back(line[from]);
    }
    return result;
}

/// Whether the line turns back in the picture within reach of a place.
bool turns_back(const Places& line, bool closed, std::size_t at, double reach) {
    Places way = course(line, closed, at, -1, 2 * reach);
    std::reverse(way.begin(), way.end());
    const Places on = course(line, closed, at, 1, 2 * reach);
    way.insert(way.end(), on.begin() + 1, on.end());
    std::vector<double> lengths = {0};
    for (std::size_t i = 1; i < way.size(); ++i)
        lengths.push_back(lengths.back() + flat(way[i] - way[i - 1]).norm());
    const auto index_at = [&](double length) {
        const auto found = std::lower_bound(lengths.begin(), lengths.end(), length);
        return std::min(std::size_t(found - lengths.begin()), way.size() - 1);
    };
    for (std::size_t i = 0; i < way.size(); ++i) {
        const std::size_t before = index_at(lengths[i] - reach),
                          after = index_at(lengths[i] + reach);
        if (flat(way[i] - way[before]).dot(flat(way[after] - way[i])) < 0) return true;
    }
    return false;
}

/// Whether a contour that ends here by itself goes on in another outline.
bool meets_another(const Vector3d& end, const Polyline& own, const Picture& whole, double reach) {
    for (const Polyline& line : whole.lines().lines) {
        if (&line == &own || !is_outline(line)) continue;
        const std::uint32_t last = line.first + line.count - 1;
        for (std::uint32_t i = line.first; i <= last; ++i) {
            const bool counts = line.kind == LineKind::Border || i == line.first || i == last;
            if (counts && (whole.points[i] - end).norm() < reach) return true;
        }
    }
    return false;
}

}  // namespace

LineEnds& LineEnds::operator+=(const LineEnds& other) {
    all += other.all;
    crossings += other.crossings;
    cusps += other.cusps;
    meetings += other.meetings;
    return *this;
}

LineEnds ends_of_contours(const LineSet& whole_lines, const LineSet& seen_lines, const View& view,
                          double reach) {
    const Picture whole(whole_lines, view), seen(seen_lines, view);
    LineEnds ends;
    for (const Polyline& part : seen_lines.lines) {
        if (part.kind != LineKind::Contour || part.closed) continue;
        for (const std::uint32_t i : {part.first, part.first + part.count - 1}) {
            const Vector3d& end = seen.points[i];
            ++ends.all;
            if (crosses_a_nearer_outline(end, seen, reach)) {
                ++ends.crossings;
                continue;
            }
            const Origin origin = origin_of(end, whole);
            const Places line = whole.along(*origin.line);
            const bool is_own_end =
                !origin.line->closed &&
                std::min((line.front() - end).norm(), (line.back() - end).norm()) < 1e-3 * reach;
            if (turns_back(line, origin.line->closed, origin.segment, reach))
                ++ends.cusps;
            else if (is_own_end && meets_another(end, *origin.line, whole, reach))
                ++ends.meetings;
        }
    }
    return ends;
}

}  // namespace benchmarks
