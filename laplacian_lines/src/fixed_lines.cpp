// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed_lines.h"

#include <algorithm>
#include <cmath>

#include "crossings.h"
#include "line_smoothing.h"
#include "mesh_edge_lines.h"
#include "ridges.h"

namespace laplacian_lines {
namespace {

constexpr float kPinhole = 3;  // shortest lines around a hole that is worth a border

struct FixedRules {
    float least_angle = 0;   ///< degrees
    float fading = 0;        ///< full at (1 + fading) times the angle
    float least_length = 0;  ///< D
    int smoothing_passes = 0;
};

float opacity(const FixedRules& rules, float angle) {
    if (angle < rules.least_angle) return 0;
    const float range = rules.least_angle * rules.fading;
    return range > 0 ? std::min((angle - rules.least_angle) / range, 1.f) : 1.f;
}

/// Appends one line of the set with the opacity that its angles deserve, unless it has none.
void append_line(const LineSet& set, Polyline line, const FixedRules& rules, LineSet& lines) {
    const LinePoint* begin = set.points.data() + line.first;
    line.first = std::uint32_t(lines.points.size());
    lines.points.insert(lines.points.end(), begin, begin + line.count);
    LinePoint* points = lines.points.data() + line.first;
    float most = 0;
    for (LinePoint* p = points; p < points + line.count; ++p) {
        p->opacity = p->weight = opacity(rules, p->gradient);
        most = std::max(most, p->opacity);
    }
    if (most == 0) {
        lines.points.resize(line.first);
        return;
    }
    for (int pass = 0; pass < rules.smoothing_passes; ++pass)
        smooth_line(line, points, &LinePoint::position, LineEnd::Reflected);
    lines.lines.push_back(line);
}

void append_lines(const LineSet& set, const FixedRules& rules, LineSet& lines) {
    for (const Polyline& line : set.lines)
        if (line.length >= rules.least_length) append_line(set, line, rules, lines);
}

}  // namespace

const MeshEdges& FixedLines::mesh_edges(const ExtractorData& data) {
    return mesh_edges_.get([&] { return find_mesh_edges(data); });
}

void FixedLines::append(const ExtractorData& data, const LineStyle& style, LineSet& lines) {
    const double factor = threshold_factor(style.detail);
    const float shortest = float(std::sqrt(factor) * style.shortest_line);
    if (style.ridges) {
        // Angles differ less than slopes do: the eighth root, and part of the fading.
        const float angle = float(std::pow(factor, 0.125) * style.ridge_angle);
        append_lines(
            ridges_.get([&] { return find_ridges(data); }),
            {angle, 0.4f * float(style.fading), shortest, smoothing_passes(style.line_smoothing)},
            lines);
    }
    if (style.borders)
        append_lines(borders_.get([&] { return find_borders(data, mesh_edges(data)); }),
                     {0, 0, kPinhole * shortest, 0}, lines);
    if (style.creases)
        append_lines(creases_.get([&] { return find_creases(data, mesh_edges(data)); }),
                     {float(style.crease_angle), 0, shortest, 0}, lines);
}

}  // namespace laplacian_lines
