// SPDX-License-Identifier: GPL-3.0-or-later
#include "kind_truth.h"

#include <algorithm>

#include "generators.h"
#include "helpers.h"

namespace reference {

using namespace laplacian_lines;
using test_meshes::AnalyticMesh;

namespace {

constexpr double kClear = 1.5;  // times a threshold, or its inverse

}  // namespace

const std::vector<Refinement>& refinements() {
    static const std::vector<Refinement> list = {
        {"torus", [](int l) { return test_meshes::torus(48 << l, 24 << l); }},
        {"ellipsoid", [](int l) { return test_meshes::ellipsoid(l + 4); }},
        {"bumpy sphere", [](int l) { return test_meshes::bumpy_sphere(l + 4); }},
        {"hills", [](int l) { return test_meshes::hills(40 << l); }, 0.2},
    };
    return list;
}

const std::vector<LineKind> true_kinds = {
    LineKind::Contour,           LineKind::Laplacian,
    LineKind::SuggestiveContour, LineKind::SuggestiveHighlight,
    LineKind::ApparentRidge,     LineKind::PhoticExtremum,
    LineKind::DemarcatingCurve};

std::vector<NamedView> views_of(const FieldScale& scale) {
    const Eigen::Vector3d direction = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
    return {{"near", View::perspective(0.7 * scale.diagonal * direction)},
            {"far", View::perspective(10 * scale.diagonal * direction)},
            {"orthographic", View::orthographic(direction)}};
}

Field true_field(const AnalyticMesh& surface, const FieldScale& scale) {
    Field field;
    field.scale = scale;
    for (const test_meshes::SurfacePoint& p : surface.truth) {
        const Eigen::Matrix3f s = p.shape_operator.cast<float>();
        field.normals.push_back(p.normal.cast<float>());
        field.laplacian_normals.push_back(p.laplacian_normal.cast<float>());
        field.shape_operators.push_back({s(0, 0), s(1, 1), s(2, 2), s(1, 2), s(0, 2), s(0, 1)});
        field.kernel_sizes.push_back(float(scale.kernel_size));
        field.smooth_curvatures.push_back(
            helpers::curvature_entries(p.shape_operator, field.normals.back()).cast<float>());
        field.curvature_derivatives.push_back(
            helpers::derivative_entries(p.shape_derivative, field.normals.back()).cast<float>());
    }
    return field;
}

KindTruth::KindTruth(const TriangleMesh& mesh, const AnalyticMesh& fine, double border)
    : border_(border),
      field_(helpers::complete_field(mesh)),
      found_(mesh, field_),
      truth_(fine.mesh, true_field(fine, field_.scale)) {}

/// Nothing makes lines fade, end or move. Slopes and thresholds scale with what normals are seen
/// at, so that they mean the same on finer meshes.
LineStyle KindTruth::style(LineKind kind, double factor) const {
    constexpr double usual = 0.1;  // D, the kernel for which thresholds are the default ones
    const double size = field_.scale.kernel_size / field_.scale.diagonal / usual;
    LineStyle style = helpers::only(kind);
    style.fading = style.line_smoothing = style.end_length = style.contour_clearance = 0;
    style.exact_outlines = style.single_strokes = false;
    style.apparent_curvature = 3 * factor;
    style.demarcation *= factor * size * size;
    for (double* const threshold :
         {&style.gradient_threshold, &style.strength_threshold, &style.shortest_line})
        *threshold *= factor;
    for (double* const threshold :
         {&style.segment_slope, &style.line_slope, &style.suggestive_slope, &style.apparent_slope,
          &style.photic_slope})
        *threshold *= factor * size * size * size;
    return style;
}

void KindTruth::add_distances(const LineSet& lines, const LineSet& others,
                              LineDistance& distance) const {
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
            const Eigen::Vector3d a = lines.points[i - 1].position.cast<double>(),
                                  b = lines.points[i].position.cast<double>();
            if (border_ > 0 && b.head<2>().cwiseAbs().maxCoeff() > 1 - border_) continue;
            const double d = field_.scale.diagonal,
                         away =
                             others.lines.empty() ? 1 : helpers::distance_to_lines(b, others) / d,
                         length = (b - a).norm() / d;
            distance.largest = std::max(distance.largest, away);
            distance.mean += away * length;
            distance.length += length;
        }
}

LineDistance KindTruth::distance(LineKind kind, const View& view) const {
    const auto lines = [&](const LineExtractor& extractor, double factor) {
        return helpers::extract(extractor, view, style(kind, factor));
    };
    LineDistance distance;
    add_distances(lines(found_, kClear), lines(truth_, 1 / kClear), distance);
    add_distances(lines(truth_, kClear), lines(found_, 1 / kClear), distance);
    if (distance.length > 0) distance.mean /= distance.length;
    return distance;
}

LineDistance KindTruth::over_views(LineKind kind) const {
    LineDistance sum;
    for (const NamedView& view : views_of(scale())) {
        const LineDistance one = distance(kind, view.view);
        sum.largest = std::max(sum.largest, one.largest);
        sum.mean += one.mean * one.length;
        sum.length += one.length;
    }
    if (sum.length > 0) sum.mean /= sum.length;
    return sum;
}

}  // namespace reference
