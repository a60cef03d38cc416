// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_stream.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace line_renderer {

using laplacian_lines::LineKind;
using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::Polyline;

namespace {

StreamPoint at(const LinePoint& point, float radius, LineKind kind, float along) {
    const Eigen::Vector3f& p = point.position;
    return {{p.x(), p.y(), p.z()}, radius, point.opacity, float(kind), along};
}

float taperedRadius(float full, float least_share, float weight) {
    return full * (least_share + (1 - least_share) * std::clamp(weight, 0.0f, 1.0f));
}

struct ScreenPlace {
    Eigen::Vector2f pixel = Eigen::Vector2f::Zero();
    bool is_known = false;
};

ScreenPlace placeOf(const LinePoint& point, const ScreenTransform& screen) {
    const Eigen::Vector4f clip = screen.to_clip * point.position.homogeneous();
    if (clip.w() <= 0) return {};
    return {clip.head<2>().cwiseProduct(screen.half_viewport) / clip.w(), true};
}

/// Length of a line on the screen, point by point.
class LengthOnScreen {
public:
    explicit LengthOnScreen(const ScreenTransform* screen) : screen_(screen) {}

    float upTo(const LinePoint& point) {
        if (!screen_) return 0;
        const ScreenPlace here = placeOf(point, *screen_);
        if (here.is_known && previous_.is_known) length_ += (here.pixel - previous_.pixel).norm();
        previous_ = here;
        return length_;
    }

private:
    const ScreenTransform* screen_;
    float length_ = 0;
    ScreenPlace previous_;
};

bool isDrawn(const Polyline& line) {
    return line.count >= 2;
}

}  // namespace

std::size_t streamLength(const LineSet& lines) {
    std::size_t length = 0;
    for (const Polyline& line : lines.lines)
        if (isDrawn(line)) length += line.count + 2;
    return length;
}

void writeStream(const LineSet& lines, const LineRadii& radii, const ScreenTransform* screen,
                 StreamPoint* stream) {
    for (const Polyline& line : lines.lines) {
        if (!isDrawn(line)) continue;
        const LinePoint* first = lines.points.data() + line.first;
        const LinePoint* last = first + line.count - 1;
        const float full = radii.full.at(std::size_t(line.kind));
        const float mark = line.closed ? neighbour_only : nothing_here;
        LengthOnScreen length(screen);
        // a closed line ends with a copy of its first point, so its neighbours are one further in
        *stream++ = at(*(last - 1), mark, line.kind, 0);
        for (const LinePoint* point = first; point <= last; ++point)
            *stream++ = at(*point, taperedRadius(full, radii.least_share, point->weight), line.kind,
                           length.upTo(*point));
        *stream++ = at(*(first + 1), mark, line.kind, 0);
    }
}

}  // namespace line_renderer
