// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections/wall_area.h"

#include <algorithm>
#include <cmath>

namespace line_drawing {
namespace {

constexpr std::size_t row_count = 256;

}  // namespace

WallArea::WallArea(const Wall& loops) {
    Eigen::AlignedBox2d box;
    for (const auto& loop : loops)
        for (const Eigen::Vector2d& p : loop)
            box.extend(p);
    if (box.isEmpty()) return;
    rows_.resize(row_count);
    low_ = box.min().y();
    row_height_ = std::max(box.sizes().y() / row_count, 1e-12);
    for (const auto& loop : loops)
        for (std::size_t i = 1; i < loop.size(); ++i) {
            const auto [low, high] = std::minmax({loop[i - 1].y(), loop[i].y()});
            for (std::size_t row = rowOf(low); row <= rowOf(high); ++row)
                rows_[row].push_back({loop[i - 1], loop[i]});
        }
}

std::size_t WallArea::rowOf(double y) const {
    return std::size_t(std::clamp((y - low_) / row_height_, 0., double(row_count - 1)));
}

bool WallArea::contains(const Eigen::Vector2d& point) const {
    if (rows_.empty()) return false;
    bool is_inside = false;
    for (const Edge& edge : rows_[rowOf(point.y())]) {
        if ((edge.begin.y() <= point.y()) == (edge.end.y() <= point.y())) continue;
        const double t = (point.y() - edge.begin.y()) / (edge.end.y() - edge.begin.y());
        if (edge.begin.x() + t * (edge.end.x() - edge.begin.x()) > point.x())
            is_inside = !is_inside;
    }
    return is_inside;
}

std::vector<DrawnLine> withoutPartsIn(const WallArea& area, std::vector<DrawnLine> lines) {
    std::vector<DrawnLine> rest;
    for (DrawnLine& line : lines) {
        DrawnLine part{line.line_class, false, {}};
        const auto end = [&] {
            if (part.points.size() > 1) {
                part.closed = line.closed && part.points.size() == line.points.size();
                rest.push_back(part);
            }
            part.points.clear();
        };
        for (const DrawnPoint& point : line.points)
            if (area.contains(point.position))
                end();
            else
                part.points.push_back(point);
        end();
    }
    return rest;
}

}  // namespace line_drawing
