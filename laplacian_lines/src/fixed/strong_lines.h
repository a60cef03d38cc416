// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>
#include <vector>

#include "fixed/showing.h"
#include "fixed/stretches.h"

namespace laplacian_lines {

/// Shows strong places of lines, by their gradient, and weaker ones that continue them.
struct StrongLineRules {
    static constexpr float kWeak = 0.5f;  ///< of the least gradient: continues what is stronger

    float least;                       ///< gradient
    float fading;                      ///< from nothing at kWeak to full opacity
    float least_length, least_strong;  ///< of a stretch and of its strong part, D
    int smoothing_passes;

    bool operator==(const StrongLineRules& other) const {
        const auto all = [](const StrongLineRules& r) {
            return std::tie(r.least, r.fading, r.least_length, r.least_strong, r.smoothing_passes);
        };
        return all(*this) == all(other);
    }
};

inline std::vector<float> strongest_of(const LineSet& set) {
    std::vector<float> strongest;
    for (const Polyline& line : set.lines) {
        float most = 0;
        for (std::uint32_t i = 0; i < line.count; ++i)
            most = std::max(most, set.points[line.first + i].gradient);
        strongest.push_back(most);
    }
    return strongest;
}

/// Appends what the rules show of found lines. `strongest` is strongest_of() them; share_of(number
/// of a point) multiplies its opacity.
template <class ShareOf>
void append_strong(const LineSet& found, const std::vector<float>& strongest,
                   const StrongLineRules& rules, float diagonal, const ShareOf& share_of,
                   LineSet& lines) {
    const float weak = StrongLineRules::kWeak * rules.least;
    for (std::size_t number = 0; number < found.lines.size(); ++number) {
        const Polyline& whole = found.lines[number];
        if (strongest[number] < rules.least || whole.length < rules.least_length) continue;
        const LinePoint* points = found.points.data() + whole.first;
        for_each_stretch(whole, points, weak, [&](const Stretch& stretch) {
            const StretchLengths lengths = measure(stretch, points, rules.least, diagonal);
            if (stretch.count < 2 || lengths.all < rules.least_length ||
                lengths.strong < rules.least_strong)
                return;
            Polyline line = whole;
            line.first = std::uint32_t(lines.points.size());
            line.count = stretch.count;
            line.closed = stretch.is_closed;
            line.length = lengths.all;
            for (std::uint32_t i = 0; i < stretch.count; ++i) {
                const std::uint32_t place = whole.first + stretch.point(i);
                LinePoint point = found.points[place];
                point.opacity = point.weight =
                    angle_opacity(point.gradient, weak, rules.fading) * share_of(place);
                lines.points.push_back(point);
            }
            smooth_positions(line, lines.points.data() + line.first, rules.smoothing_passes);
            lines.lines.push_back(line);
        });
    }
}

}  // namespace laplacian_lines
