// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "laplacian_lines/kernel_levels.h"

namespace laplacian_lines {
namespace {

/// Appends the Laplacian lines of another set, with this share of their width and opacity.
void append_faded(const LineSet& others, float share, LineSet& lines) {
    for (Polyline line : others.lines) {
        if (line.kind != LineKind::Laplacian) continue;
        const auto first = others.points.begin() + line.first;
        line.first = std::uint32_t(lines.points.size());
        lines.lines.push_back(line);
        std::transform(first, first + line.count, std::back_inserter(lines.points),
                       [=](LinePoint point) {
                           point.weight *= share;
                           point.opacity *= share;
                           return point;
                       });
    }
}

/// Laplacian lines, and the contours that they must keep clear of.
LineStyle laplacian_lines_of(LineStyle style) {
    const bool has_contours = style.shows[LineKind::Contour];
    style.shows = {};
    style.shows[LineKind::Laplacian] = true;
    style.shows[LineKind::Contour] = has_contours;
    style.exact_outlines = false;
    return style;
}

}  // namespace

void extract_kernels(const LineExtractor& extractor, const View& view, const LineStyle& style,
                     const std::vector<DrawnKernel>& kernels, ExtractionScratch& scratch,
                     LineSet& others, LineSet& lines) {
    extractor.extract(view, style, scratch, lines, kernels.at(0).laplacian);
    if (kernels.size() < 2 || !style.shows[LineKind::Laplacian]) return;
    extractor.extract(view, laplacian_lines_of(style), scratch, others, kernels[1].laplacian);
    append_faded(others, float(kernels[1].share), lines);
}

}  // namespace laplacian_lines
