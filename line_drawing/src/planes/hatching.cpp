// SPDX-License-Identifier: GPL-3.0-or-later
// A hatching line enters and leaves an area by turns; where areas overlap, its parts are joined.
#include "planes/hatching.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace line_drawing {

using Eigen::Vector2d;

namespace {

using Strip = std::pair<double, double>;

/// The parts of a line within the union of the areas.
std::vector<Strip> strips_at(const std::vector<Loops>& areas, const Vector2d& direction,
                             double offset) {
    std::vector<Strip> all, joined;
    for (const Loops& loops : areas) {
        const std::vector<double> crossings = crossings_at(loops, direction, offset);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            all.emplace_back(crossings[i], crossings[i + 1]);
    }
    std::sort(all.begin(), all.end());
    for (const Strip& strip : all)
        if (joined.empty() || strip.first > joined.back().second)
            joined.push_back(strip);
        else
            joined.back().second = std::max(joined.back().second, strip.second);
    return joined;
}

}  // namespace

std::vector<double> crossings_at(const Loops& loops, const Vector2d& direction, double offset) {
    const Vector2d across(-direction.y(), direction.x());
    std::vector<double> crossings;
    for (const auto& loop : loops)
        for (std::size_t i = 1; i < loop.size(); ++i) {
            const double a = across.dot(loop[i - 1]) - offset, b = across.dot(loop[i]) - offset;
            if ((a < 0) == (b < 0)) continue;
            crossings.push_back(
                direction.dot(loop[i - 1] + (loop[i] - loop[i - 1]) * (a / (a - b))));
        }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
}

std::vector<std::vector<Vector2d>> hatch(const std::vector<Loops>& areas, const Vector2d& direction,
                                         double spacing) {
    const Vector2d across(-direction.y(), direction.x());
    double low = INFINITY, high = -INFINITY;
    for (const Loops& loops : areas)
        for (const auto& loop : loops)
            for (const Vector2d& p : loop) {
                low = std::min(low, across.dot(p));
                high = std::max(high, across.dot(p));
            }
    std::vector<std::vector<Vector2d>> lines;
    for (double at = (std::floor(low / spacing) + 0.5) * spacing; at < high; at += spacing)
        for (const auto& [begin, end] : strips_at(areas, direction, at))
            lines.push_back({at * across + begin * direction, at * across + end * direction});
    return lines;
}

}  // namespace line_drawing
