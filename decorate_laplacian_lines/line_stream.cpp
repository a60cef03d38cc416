// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_stream.h"

#include <algorithm>

using laplacian_lines::LineKind;
using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::Polyline;

namespace {

StreamPoint at(const LinePoint& point, float radius) {
    return {{point.position.x(), point.position.y(), point.position.z()}, radius};
}

float taperedRadius(float full, float least_share, float weight) {
    return full * (least_share + (1 - least_share) * std::clamp(weight, 0.0f, 1.0f));
}

}  // namespace

void makeStream(const LineSet& lines, const LineRadii& radii, std::vector<StreamPoint>& stream) {
    stream.clear();
    stream.reserve(lines.points.size() + 2 * lines.lines.size());
    for (const Polyline& line : lines.lines) {
        if (line.count < 2) continue;
        const LinePoint* first = lines.points.data() + line.first;
        const LinePoint* last = first + line.count - 1;
        const float full = line.kind == LineKind::Contour ? radii.contour : radii.laplacian;
        const float mark = line.closed ? neighbour_only : nothing_here;
        // a closed line ends with a copy of its first point, so its neighbours are one further in
        stream.push_back(at(*(last - 1), mark));
        for (const LinePoint* point = first; point <= last; ++point)
            stream.push_back(at(*point, taperedRadius(full, radii.least_share, point->weight)));
        stream.push_back(at(*(first + 1), mark));
    }
}
