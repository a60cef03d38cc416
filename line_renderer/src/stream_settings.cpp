// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_stream.h"

#include "laplacian_lines/line_visibility.h"

namespace line_renderer {
namespace {

/// Share of a line's clearance by which its drawn depth may differ.
constexpr double depth_share = 0.25;

LineTolerance toleranceOf(const LinePlacement& placement) {
    LineTolerance result;
    result.distance = float(placement.tolerance);
    const Eigen::Matrix4d& p = placement.projection;
    // Change of depth in -1..1 with the distance from the eye, times w².
    const double slope = std::abs(p(2, 2) * p(3, 3) - p(2, 3) * p(3, 2));
    for (std::size_t look = 0; look < result.depth.size(); ++look)
        result.depth[look] = float(depth_share * slope * lineClearance(look, placement));
    return result;
}

}  // namespace

LineRadii lineRadii(const LineAppearance& appearance, double pixel_scale) {
    LineRadii result;
    for (std::size_t look = 0; look < result.full.size(); ++look)
        result.full[look] = float(appearance.looks[look].width * pixel_scale / 2);
    return result;
}

double lineClearance(std::size_t look, const LinePlacement& placement) {
    return meanScale(placement.to_eye) *
           laplacian_lines::sight_clearance(laplacian_lines::line_kinds[look].kind,
                                            placement.diagonal, placement.sight_edge);
}

StreamSettings streamSettings(const LineAppearance& appearance, const LinePlacement& placement,
                              const Eigen::Vector2f& half_viewport) {
    const Eigen::Matrix4d to_clip =
        placement.picture_to_clip.value_or(placement.projection * placement.to_eye);
    StreamSettings settings;
    settings.radii = lineRadii(appearance, placement.pixel_scale);
    settings.screen = {to_clip.cast<float>(), half_viewport};
    settings.tolerance = toleranceOf(placement);
    settings.is_measured = appearance.hidden == HiddenLines::Dashed;
    return settings;
}

}  // namespace line_renderer
