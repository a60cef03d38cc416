// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/fixed_lines.h"

#include <algorithm>
#include <cmath>

#include "clusters/whole_mesh.h"
#include "fixed/line_smoothing.h"
#include "fixed/mesh_edge_lines.h"
#include "rules/contour_clearance.h"
#include "rules/line_rules.h"

namespace laplacian_lines {
namespace {

constexpr float kPinhole = 3;  // shortest lines around a hole that is worth a border

struct FixedRules {
    float least_length = 0;  ///< D
    int smoothing_passes = 0;
};

/// Appends the lines of the set that are long enough and have a point to be seen.
/// `opacity_of(i)` is the opacity of point i of the set; `may_show(i)` is false if that is 0 for
/// all points of line i.
template <class MayShow, class OpacityOf>
void append_lines(const LineSet& set, const FixedRules& rules, const MayShow& may_show,
                  const OpacityOf& opacity_of, LineSet& lines) {
    for (std::size_t number = 0; number < set.lines.size(); ++number) {
        Polyline line = set.lines[number];
        if (line.length < rules.least_length || !may_show(number)) continue;
        const std::size_t begin = line.first, end = begin + line.count;
        line.first = std::uint32_t(lines.points.size());
        float most = 0;
        for (std::size_t i = begin; i < end; ++i) {
            LinePoint point = set.points[i];
            point.opacity = point.weight = opacity_of(i);
            most = std::max(most, point.opacity);
            lines.points.push_back(point);
        }
        if (most == 0) {
            lines.points.resize(line.first);
            continue;
        }
        smooth_positions(line, lines.points.data() + line.first, rules.smoothing_passes);
        lines.lines.push_back(line);
    }
}

/// From nothing at the angle to full at (1 + fading) times it.
float angle_opacity(float angle, float least_angle, float fading) {
    if (angle < least_angle) return 0;
    const float range = least_angle * fading;
    return range > 0 ? std::min((angle - least_angle) / range, 1.f) : 1.f;
}

}  // namespace

const MeshEdges& FixedLines::mesh_edges(const ExtractorData& data) {
    return mesh_edges_.get([&] { return find_mesh_edges(rebuild_mesh(data)); });
}

void FixedLines::append_ridges(const ExtractorData& data, const LocalEye& eye,
                               const LineStyle& style, float shortest, LineSet& lines) {
    const Ridges& ridges = ridges_.get([&] { return find_ridges(data); });
    // Angles differ less than slopes do: the eighth root, and part of the fading.
    const float angle = float(std::pow(threshold_factor(style.detail), 0.125) * style.ridge_angle);
    const float fading = 0.4f * float(style.fading);
    // The contour of a rounded edge stays near its crest for long.
    const float clearance = style.shows[LineKind::Contour] ? 4 * float(style.contour_clearance) : 0;
    const auto opacity_of = [&](std::size_t i) {
        const LinePoint& point = ridges.lines.points[i];
        const float opacity = angle_opacity(point.gradient, angle, fading);
        if (opacity == 0) return opacity;
        const Eigen::Vector3f l = eye.towards(
            ((point.position.cast<double>() - data.centre) / data.diagonal).cast<float>());
        const Ridges::Form& form = ridges.forms[i];
        const float facing = std::abs(form.normal.dot(l));
        const float gradient = std::abs(form.bend.dot(l));
        return opacity * clearance_opacity(facing, std::max(gradient, 1e-6f), clearance);
    };
    append_lines(
        ridges.lines, {shortest, smoothing_passes(style.line_smoothing)},
        [&](std::size_t line) { return ridges.sharpest[line] >= angle; }, opacity_of, lines);
}

void FixedLines::append(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                        LineSet& lines) {
    const float shortest = float(std::sqrt(threshold_factor(style.detail)) * style.shortest_line);
    const auto always = [](std::size_t) { return true; };
    if (style.shows[LineKind::Ridge]) append_ridges(data, eye, style, shortest, lines);
    if (style.shows[LineKind::Border])
        append_lines(
            borders_.get([&] { return find_borders(data); }), {kPinhole * shortest, 0}, always,
            [](std::size_t) { return 1.f; }, lines);
    if (style.shows[LineKind::Crease]) {
        const LineSet& creases =
            creases_.get([&] { return find_creases(data, find_mesh_edges(rebuild_mesh(data))); });
        const float angle = float(style.crease_angle);
        append_lines(
            creases, {shortest, 0}, always,
            [&](std::size_t i) { return angle_opacity(creases.points[i].gradient, angle, 0); },
            lines);
    }
}

}  // namespace laplacian_lines
