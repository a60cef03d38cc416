// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/line_visibility.h"

#include <algorithm>
#include <array>
#include <limits>

#include "clusters/coarseness.h"
#include "laplacian_lines/precompute_options.h"
#include "system/parallel.h"
#include "visibility/line_parts.h"
#include "visibility/ray_caster.h"

namespace laplacian_lines {
namespace {

// In D: largest distance of places that are looked at.
constexpr double kSpacing = 0.004;
// In D: a contour that is seen to one of its sides is seen, so that the horizon that it follows
// does not hide it.
constexpr double kToSide = 0.0015;
// In D: where edges are longer on the mean, many triangles are coarse, unless the mesh is rough.
constexpr double kLargestSmoothMeanEdge = 0.025;

/// Whether a place on a line is seen from the eye. For one line and one thread.
class Sight {
public:
    Sight(const RayCaster& caster, const View& view, double clearance, double to_side)
        : caster_(caster), view_(view), clearance_(clearance), to_side_(to_side) {}

    bool reaches(const Eigen::Vector3d& point, const Eigen::Vector3d& tangent) {
        const Eigen::Vector3d to_eye = view_.eye - view_.w * point;
        const double distance = to_eye.norm();
        if (!(distance > 0)) return true;
        if (is_clear(point, hints_[0])) return true;
        if (to_side_ == 0) return false;
        const Eigen::Vector3d side = to_eye.cross(tangent).stableNormalized() * to_side_;
        return is_clear(point + side, hints_[1]) || is_clear(point - side, hints_[2]);
    }

private:
    bool is_clear(const Eigen::Vector3d& point, RayCaster::Hint& hint) {
        const Eigen::Vector3d to_eye = view_.eye - view_.w * point;
        const Eigen::Vector3d direction = to_eye.normalized();
        const double length = view_.w == 0 ? std::numeric_limits<double>::infinity()
                                           : to_eye.norm() / std::abs(view_.w) - clearance_;
        return length <= 0 ||
               !caster_.is_hit({point + clearance_ * direction, direction, length}, hint);
    }

    const RayCaster& caster_;
    const View& view_;
    double clearance_, to_side_;
    std::array<RayCaster::Hint, 3> hints_;  // on the line, and to its sides
};

}  // namespace

struct LineVisibility::Data {
    RayCaster caster;
    double diagonal, contour_edge;  // as sight_clearance() has them

    /// The parts of one line that are seen.
    LineSet seen_parts(const View& view, const LineSet& lines, const Polyline& line) const {
        const double clearance = sight_clearance(line.kind, diagonal, contour_edge);
        const double to_side = describe(line.kind).is_on_horizon ? kToSide * diagonal : 0;
        Sight sight(caster, view, clearance, to_side);
        const LinePoint* points = lines.points.data() + line.first;
        const auto is_seen = [&](const LinePlace& place) {
            const Eigen::Vector3f tangent =
                points[place.segment + 1].position - points[place.segment].position;
            return sight.reaches(point_at(lines, line, place).position.cast<double>(),
                                 tangent.cast<double>());
        };
        LineSet result;
        const PartRules rules = {kSpacing * diagonal, kSightClearance * diagonal};
        for (const LinePart& part : parts_where(lines, line, rules, is_seen))
            append_part(lines, line, part, diagonal, result);
        return result;
    }
};

double sight_edge(const Field& field) {
    const FieldScale& scale = field.scale;
    if (scale.mean_edge > kLargestSmoothMeanEdge * scale.diagonal && !is_rough(field.report))
        return 0;
    return std::max(scale.mean_edge, scale.normal_sigma / automatic_normal_sigma(0));
}

LineVisibility::LineVisibility(const TriangleMesh& mesh, const Field& field,
                               const Progress& progress)
    : data_(std::make_unique<const Data>(
          Data{RayCaster(mesh, {progress, 0, 1, "Preparing what hides lines"}),
               field.scale.diagonal, sight_edge(field)})) {}
LineVisibility::~LineVisibility() = default;
LineVisibility::LineVisibility(LineVisibility&&) noexcept = default;
LineVisibility& LineVisibility::operator=(LineVisibility&&) noexcept = default;

bool LineVisibility::encloses(const Eigen::Vector3d& point) const {
    return data_->caster.winding_number(point) > 0.5;
}

LineSet LineVisibility::visible_parts(const View& view, const LineSet& lines,
                                      const Progress& progress) const {
    std::vector<LineSet> parts(lines.lines.size());
    const StageProgress stage(progress, 0, 1, "Finding what is seen");
    stage.report(0);
    parallel_for<NoScratch>(lines.lines.size(), stage, [&](std::size_t i, NoScratch&) {
        parts[i] = data_->seen_parts(view, lines, lines.lines[i]);
    });
    stage.report(1);
    LineSet result;
    for (const LineSet& part : parts) {
        const auto first = std::uint32_t(result.points.size());
        result.points.insert(result.points.end(), part.points.begin(), part.points.end());
        for (Polyline line : part.lines) {
            line.first += first;
            result.lines.push_back(line);
        }
    }
    return result;
}

}  // namespace laplacian_lines
