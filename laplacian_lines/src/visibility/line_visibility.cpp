// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/line_visibility.h"

#include <algorithm>

#include "clusters/coarseness.h"
#include "laplacian_lines/precompute_options.h"
#include "system/parallel.h"
#include "visibility/line_decision.h"
#include "visibility/line_parts.h"
#include "visibility/picture_crossings.h"
#include "visibility/ray_caster.h"
#include "visibility/sight.h"

namespace laplacian_lines {
namespace {

constexpr double kSidesShare = 0.1;  // of the time
// In D: where edges are longer on the mean, many triangles are coarse, unless the mesh is rough.
constexpr double kLargestSmoothMeanEdge = 0.025;

LineSet joined(const std::vector<LineSet>& parts) {
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

std::vector<SightLengths> lengths_of(const std::vector<const Field*>& fields) {
    std::vector<SightLengths> lengths;
    for (const Field* field : fields)
        lengths.push_back({field->scale.diagonal, field->scale.mean_edge, sight_edge(*field)});
    return lengths;
}

double largest_diagonal(const std::vector<SightLengths>& lengths) {
    double largest = 0;
    for (const SightLengths& l : lengths)
        largest = std::max(largest, l.diagonal);
    return largest;
}

}  // namespace

struct LineVisibility::Data {
    RayCaster caster;
    std::vector<SightLengths> lengths;  // of each surface
};

double sight_edge(const Field& field) {
    const FieldScale& scale = field.scale;
    if (scale.mean_edge > kLargestSmoothMeanEdge * scale.diagonal && !is_rough(field.report))
        return 0;
    return std::max(scale.mean_edge, scale.normal_sigma / automatic_normal_sigma(0));
}

LineVisibility::LineVisibility(const TriangleMesh& mesh, const Field& field,
                               const Progress& progress)
    : LineVisibility(mesh, std::vector<const Field*>{&field}, progress) {}
LineVisibility::LineVisibility(const TriangleMesh& mesh, const std::vector<const Field*>& fields,
                               const Progress& progress)
    : data_(std::make_unique<const Data>(Data{
          RayCaster(mesh, {progress, 0, 1, "Preparing what hides lines"}), lengths_of(fields)})) {}
LineVisibility::~LineVisibility() = default;
LineVisibility::LineVisibility(LineVisibility&&) noexcept = default;
LineVisibility& LineVisibility::operator=(LineVisibility&&) noexcept = default;

bool LineVisibility::encloses(const Eigen::Vector3d& point) const {
    return data_->caster.winding_number(point) > 0.5;
}

LineSet LineVisibility::visible_parts(const View& view, const LineSet& lines,
                                      const Progress& progress) const {
    return parts(view, lines, progress).seen;
}

LineParts LineVisibility::parts(const View& view, const LineSet& lines,
                                const Progress& progress) const {
    return parts_of(view, lines, std::vector<std::size_t>(lines.lines.size()), progress);
}

LineParts LineVisibility::parts(const View& view, const std::vector<LineSet>& lines,
                                const Progress& progress) const {
    std::vector<std::size_t> surfaces;
    for (std::size_t surface = 0; surface < lines.size(); ++surface)
        surfaces.insert(surfaces.end(), lines[surface].lines.size(), surface);
    return parts_of(view, joined(lines), surfaces, progress);
}

LineParts LineVisibility::parts_of(const View& view, const LineSet& lines,
                                   const std::vector<std::size_t>& surfaces,
                                   const Progress& progress) const {
    const StageProgress stage(progress, 0, 1, "Finding what is seen");
    stage.report(0);
    const auto lengths_at = [&](std::size_t i) -> const SightLengths& {
        return data_->lengths.at(surfaces[i]);
    };
    const std::size_t count = lines.lines.size();
    std::vector<int> free_sides(count);
    parallel_for<NoScratch>(count, stage.part(0, kSidesShare), [&](std::size_t i, NoScratch&) {
        Sight sight(data_->caster, view);
        free_sides[i] = free_side(lines, lines.lines[i], lengths_at(i), sight);
    });
    const PictureCrossings crossings(lines, view, free_sides, largest_diagonal(data_->lengths));
    std::vector<LineSet> seen(count), hidden(count);
    parallel_for<NoScratch>(count, stage.part(kSidesShare, 1), [&](std::size_t i, NoScratch&) {
        const Polyline& line = lines.lines[i];
        const SightLengths& lengths = lengths_at(i);
        Sight sight(data_->caster, view);
        const LineDecision decision = decide(lines, line, free_sides[i], crossings, lengths, sight);
        for (const LinePart& part : decision.seen)
            append_part(lines, line, part, lengths.diagonal, seen[i]);
        for (const LinePart& part : decision.hidden)
            append_part(lines, line, part, lengths.diagonal, hidden[i]);
    });
    return {joined(seen), joined(hidden)};
}

}  // namespace laplacian_lines
