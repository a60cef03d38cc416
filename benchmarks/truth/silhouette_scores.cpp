// SPDX-License-Identifier: GPL-3.0-or-later
#include "silhouette_scores.h"

#include "near_segments.h"

namespace benchmarks {
namespace {

constexpr double near_line = 0.15, far_line = 0.8, least_jump = 0.5;  // mm

}  // namespace

void SilhouetteScores::add(const SilhouetteScores& other) {
    border += other.border;
    bare_border += other.bare_border;
    far_border += other.far_border;
    jumps += other.jumps;
    bare_jumps += other.bare_jumps;
}

SilhouetteScores score_silhouette(const ItemBuffer& items, const DrawnPaths& drawing,
                                  BarePlaces* bare) {
    const PlaneLines lines = lines_of(drawing);
    const NearSegments near(lines, near_line), far(lines, far_line);
    const auto has_line = [](const NearSegments& segments, const PlanePoint& p) {
        return segments.any_near(p, [](const NearPlace&) { return true; });
    };
    SilhouetteScores scores;
    for (const PlanePoint& p : items.border()) {
        ++scores.border;
        if (has_line(near, p)) continue;
        ++scores.bare_border;
        scores.far_border += !has_line(far, p);
        if (bare) bare->border.push_back(p);
    }
    for (const PlanePoint& p : items.jumps(least_jump)) {
        ++scores.jumps;
        if (has_line(near, p)) continue;
        ++scores.bare_jumps;
        if (bare) bare->jumps.push_back(p);
    }
    return scores;
}

}  // namespace benchmarks
