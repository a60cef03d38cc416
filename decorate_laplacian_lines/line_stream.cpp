// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_stream.h"

#include <Eigen/Geometry>
#include <algorithm>

using laplacian_lines::LineKind;
using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::Polyline;

namespace {

StreamPoint at(const LinePoint& point, float radius, LineKind kind) {
    const Eigen::Vector3f& p = point.position;
    return {{p.x(), p.y(), p.z()}, radius, point.opacity, is_outline(kind) ? 1.0f : 0.0f, 0};
}

float taperedRadius(float full, float least_share, float weight) {
    return full * (least_share + (1 - least_share) * std::clamp(weight, 0.0f, 1.0f));
}

struct ScreenPlace {
    Eigen::Vector2f pixel = Eigen::Vector2f::Zero();
    bool is_known = false;
};

ScreenPlace placeOf(const StreamPoint& point, const ScreenTransform& screen) {
    const Eigen::Map<const Eigen::Vector3f> position(point.position);
    const Eigen::Vector4f clip = screen.to_clip * position.homogeneous();
    if (clip.w() <= 0) return {};
    return {clip.head<2>().cwiseProduct(screen.half_viewport) / clip.w(), true};
}

}  // namespace

void makeStream(const LineSet& lines, const LineRadii& radii, std::vector<StreamPoint>& stream) {
    stream.clear();
    stream.reserve(lines.points.size() + 2 * lines.lines.size());
    for (const Polyline& line : lines.lines) {
        if (line.count < 2) continue;
        const LinePoint* first = lines.points.data() + line.first;
        const LinePoint* last = first + line.count - 1;
        const float full = is_outline(line.kind) ? radii.contour : radii.laplacian;
        const float mark = line.closed ? neighbour_only : nothing_here;
        // a closed line ends with a copy of its first point, so its neighbours are one further in
        stream.push_back(at(*(last - 1), mark, line.kind));
        for (const LinePoint* point = first; point <= last; ++point)
            stream.push_back(
                at(*point, taperedRadius(full, radii.least_share, point->weight), line.kind));
        stream.push_back(at(*(first + 1), mark, line.kind));
    }
}

void measureLines(const ScreenTransform& screen, std::vector<StreamPoint>& stream) {
    float along = 0;
    ScreenPlace previous;
    for (StreamPoint& point : stream) {
        const bool is_mark = point.radius < 0;  // between two lines
        const ScreenPlace here = is_mark ? ScreenPlace() : placeOf(point, screen);
        if (is_mark) along = 0;
        if (here.is_known && previous.is_known) along += (here.pixel - previous.pixel).norm();
        point.along = along;
        previous = here;
    }
}
