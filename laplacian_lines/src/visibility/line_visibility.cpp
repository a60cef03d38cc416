// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/line_visibility.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "clusters/coarseness.h"
#include "fixed/line_copies.h"
#include "mesh/orientation.h"
#include "system/on_demand.h"
#include "visibility/crease_marks.h"
#include "visibility/eye_frame.h"
#include "visibility/picture.h"
#include "visibility/visibility_mesh.h"
#include "visibility/visibility_pieces.h"

namespace laplacian_lines {
namespace {

// In D: meshes with longer mean edges have many coarse triangles, unless they are rough.
constexpr double kLargestSmoothMeanEdge = 0.025;
// Smoothing of normals moves contours as far as edges of this length, in standard deviations.
constexpr double kEdgeOfSigma = 1.25;

/// A. van Oosterom, J. Strackee, "The Solid Angle of a Plane Triangle", 1983. Positive from behind.
double solid_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double numerator = a.dot(b.cross(c));
    const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    return 2 * std::atan2(numerator, denominator);
}

/// Solid angles of all triangles over 4π; +1 inside a closed surface that faces outwards.
double winding_number(const PreparedMesh& mesh, const Eigen::Vector3d& point) {
    const double sum = sum_of(mesh.triangles.size(), [&](std::size_t i) {
        const Triangle& t = mesh.triangles[i];
        return solid_angle(mesh.positions[t[0]] - point, mesh.positions[t[1]] - point,
                           mesh.positions[t[2]] - point);
    });
    return sum / (4 * std::acos(-1.0));
}

/// For an eye with the whole mesh in front of it.
std::vector<ViewLine> find_visible_lines(const VisibilityMesh& mesh, const CreaseMarker& creases,
                                         const EyeFrame& frame, const std::vector<LineSet>& lines,
                                         const VisibilityOptions& options,
                                         const StageProgress& stage) {
    stage.report(0);
    const Picture picture(mesh, frame, stage.part(0, 0.3));
    const VisibilitySegments segments =
        find_visibility_segments(picture, *creases.mark(lines), lines);
    stage.report(0.4);
    const auto crossings = find_crossings(segments);
    stage.report(0.6);
    const auto pieces = find_visibility_pieces(segments, crossings, stage.part(0.6, 0.95));
    stage.report(1);
    return trace_lines(segments, pieces, options);
}

/// For an eye within the mesh: clips the mesh to the part in front of it.
void find_lines_in_front(const VisibilityMesh& mesh, const EyeFrame& frame,
                         const std::vector<LineSet>& lines, const VisibilityOptions& options,
                         const StageProgress& stage, std::vector<ViewLine>& seen) {
    const VisibilityMesh before =
        build_visibility_mesh(part_before_eye(mesh, frame), mesh, stage.part(0, 0.5));
    append_with_own_nodes(
        find_visible_lines(before, CreaseMarker(before), frame, lines, options, stage.part(0.5, 1)),
        seen);
}

}  // namespace

void append(const ViewLine& line, double diagonal, LineSet& to) {
    Polyline result;
    result.first = std::uint32_t(to.points.size());
    result.count = std::uint32_t(line.points.size());
    result.kind = line.kind;
    result.closed = line.closed;
    result.strength = line.strength;
    result.slope = line.slope;
    const ViewLinePoint* before = nullptr;
    for (const ViewLinePoint& p : line.points) {
        to.points.push_back(
            {(p.position - to.origin).cast<float>(), p.weight, p.gradient, p.opacity});
        if (before) result.length += float((p.position - before->position).norm() / diagonal);
        before = &p;
    }
    to.lines.push_back(result);
}

struct LineVisibility::Data {
    explicit Data(VisibilityMesh found) : mesh(std::move(found)) {}

    const VisibilityMesh mesh;
    const CreaseMarker creases{mesh};

    const PreparedMesh& turned() const {
        return turned_.get([&] {
            PreparedMesh turned;
            turned.positions = mesh.positions;
            turned.triangles = mesh.triangles;
            orient(turned);
            return turned;
        });
    }

private:
    mutable OnDemand<PreparedMesh> turned_;
};

double depth_bias_edge(const Field& field) {
    const FieldScale& scale = field.scale;
    if (scale.mean_edge > kLargestSmoothMeanEdge * scale.diagonal && !is_rough(field.report))
        return 0;
    return std::max(scale.mean_edge, kEdgeOfSigma * scale.normal_sigma);
}

LineSet extract_on_surface(const LineExtractor& extractor, const View& view, const LineStyle& style,
                           ExtractionScratch& scratch) {
    LineStyle unsmoothed = style;
    unsmoothed.line_smoothing = 0;
    unsmoothed.contour_clearance = 0;  // LineVisibility draws other contours
    LineSet all, result;
    extractor.extract(view, unsmoothed, scratch, all);
    result.origin = all.origin;
    for (const Polyline& line : all.lines)
        if (!is_edge_kind(line.kind)) append_whole(all, line, result);
    if (!style.shows[LineKind::Crease]) return result;
    unsmoothed.shows = {};  // with contours, creases on the horizon would be missing
    unsmoothed.shows[LineKind::Crease] = true;
    extractor.extract(view, unsmoothed, scratch, all);
    for (const Polyline& line : all.lines)
        append_whole(all, line, result);
    return result;
}

LineVisibility::LineVisibility(const TriangleMesh& mesh, const Progress& progress)
    : data_(std::make_unique<const Data>(
          build_visibility_mesh(mesh, {progress, 0, 1, "Preparing what hides lines"}))) {}
LineVisibility::~LineVisibility() = default;
LineVisibility::LineVisibility(LineVisibility&&) noexcept = default;
LineVisibility& LineVisibility::operator=(LineVisibility&&) noexcept = default;

bool LineVisibility::encloses(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d local = data_->mesh.local(point);
    return local.norm() <= kMeshReach && winding_number(data_->turned(), local) > 0.5;
}

std::vector<ViewLine> LineVisibility::visible_lines(const View& view,
                                                    const std::vector<LineSet>& lines,
                                                    const VisibilityOptions& options,
                                                    const Progress& progress) const {
    const StageProgress stage(progress, 0, 1, "Finding what is seen");
    const EyeFrame frame(data_->mesh, view);
    if (is_before_eye(data_->mesh, frame))
        return find_visible_lines(data_->mesh, data_->creases, frame, lines, options, stage);
    std::vector<ViewLine> seen;
    for (const bool looks_away : {false, true})
        find_lines_in_front(data_->mesh, EyeFrame(data_->mesh, view, looks_away), lines, options,
                            stage.part(looks_away ? 0.5 : 0, looks_away ? 1 : 0.5), seen);
    return seen;
}

LineParts LineVisibility::parts(const View& view, const std::vector<LineSet>& lines,
                                const VisibilityOptions& options, const Progress& progress) const {
    LineParts parts;
    if (!lines.empty()) parts.seen.origin = parts.hidden.origin = lines.front().origin;
    for (const ViewLine& line : visible_lines(view, lines, options, progress))
        append(line, data_->mesh.size, line.is_hidden ? parts.hidden : parts.seen);
    return parts;
}

}  // namespace laplacian_lines
