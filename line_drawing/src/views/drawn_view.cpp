// SPDX-License-Identifier: GPL-3.0-or-later
// A view in its own millimetres: the projection of space to it, and lines in it, with their class.
#include "views/drawn_view.h"

#include <algorithm>

#include "planes/clipping.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::LineKind;
using laplacian_lines::TriangleMesh;
using laplacian_lines::ViewLine;
using laplacian_lines::ViewLinePoint;

constexpr double kFaintestInnerLine = 0.5;  // mean share of the full width

double width_of(const ViewLinePoint& point) {
    return double(point.weight) * double(point.opacity);
}

double mean_width(const ViewLine& line) {
    double sum = 0;
    for (const ViewLinePoint& point : line.points)
        sum += width_of(point);
    return sum / double(line.points.size());
}

LineClass class_of(const ViewLine& line) {
    if (line.is_hidden) return LineClass::Hidden;
    if (line.is_outline) return LineClass::Outline;
    if (laplacian_lines::describe(line.kind).bounds_form) return LineClass::Contour;
    if (line.kind == LineKind::Crease) return LineClass::Edge;
    const bool is_faint = line.kind == LineKind::Laplacian && mean_width(line) < kFaintestInnerLine;
    return is_faint ? LineClass::Fine : LineClass::Inner;
}

}  // namespace

Projection::Projection(const ViewFrame& frame, const Vector3d& middle)
    : frame_(frame), origin_(frame.eye.value_or(middle)) {
    if (!frame.eye) return;
    const Vector3d ray = middle - origin_;
    distance_ = depth(middle) > 0 ? depth(middle) : ray.norm();
    if (distance_ == 0) distance_ = 1;
    if (depth(middle) > 0) middle_ = {frame.right.dot(ray), frame.up.dot(ray)};
}

double Projection::depth(const Vector3d& p) const {
    return -frame_.towards_viewer.dot(p - origin_);
}

Vector2d Projection::operator()(const Vector3d& p) const {
    const Vector2d flat(frame_.right.dot(p - origin_), frame_.up.dot(p - origin_));
    return frame_.eye ? Vector2d(distance_ / depth(p) * flat - middle_) : flat;
}

Vector3d Projection::unproject(const Vector2d& picture, double depth) const {
    const Vector2d flat = frame_.eye ? depth / distance_ * (picture + middle_) : picture;
    return origin_ + flat.x() * frame_.right + flat.y() * frame_.up - depth * frame_.towards_viewer;
}

Eigen::AlignedBox2d Projection::bounds_of(const TriangleMesh& mesh) const {
    const Vector2d reach = Vector2d::Constant(kTangentOfHalfView * distance_);
    Eigen::AlignedBox2d box;
    bool is_ahead = false;
    const auto extend = [&](const Vector3d& p) {
        is_ahead |= !frame_.eye || depth(p) > 0;
        if (!frame_.eye) {
            box.extend((*this)(p));
        } else if (depth(p) > 0) {
            const Vector2d ahead = (*this)(p) + middle_;
            box.extend(ahead.cwiseMax(-reach).cwiseMin(reach) - middle_);
        } else {  // its triangle may reach anywhere
            box.extend(reach - middle_);
            box.extend(-reach - middle_);
        }
    };
    std::vector<char> is_used(mesh.positions.size());
    for (const laplacian_lines::Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            if (v < is_used.size()) is_used[v] = 1;
    for (std::size_t v = 0; v < is_used.size(); ++v)
        if (is_used[v] && mesh.positions[v].allFinite()) extend(mesh.positions[v]);
    return is_ahead ? box : Eigen::AlignedBox2d();
}

std::vector<ViewLine> Projection::clip_to_view(std::vector<ViewLine> lines) const {
    if (!frame_.eye) return lines;
    for (const Vector3d& aside :
         {frame_.right, frame_.up, Vector3d(-frame_.right), Vector3d(-frame_.up)}) {
        const Vector3d normal = -kTangentOfHalfView * frame_.towards_viewer - aside;
        lines = clip(lines, {normal, normal.dot(origin_)});
    }
    return lines;
}

laplacian_lines::View Projection::view() const {
    return frame_.eye ? laplacian_lines::View::perspective(*frame_.eye)
                      : laplacian_lines::View::orthographic(frame_.towards_viewer);
}

DrawnPoint between(const DrawnPoint& a, const DrawnPoint& b, double t) {
    LineOrigin origin = t < 0.5 ? a.origin : b.origin;
    origin.depth = a.origin.depth + t * (b.origin.depth - a.origin.depth);
    return {a.position + t * (b.position - a.position),
            a.weight + t * (b.weight - a.weight),
            laplacian_lines::kNoNode,
            a.is_exact && b.is_exact,
            a.is_smoothed && b.is_smoothed,
            origin};
}

DrawnLine with_points(const DrawnLine& line, std::vector<DrawnPoint> points, bool closed) {
    return {line.line_class, closed, std::move(points), line.jump, line.kind};
}

std::vector<Vector2d> positions_of(const DrawnLine& line) {
    std::vector<Vector2d> positions;
    for (const DrawnPoint& point : line.points)
        positions.push_back(point.position);
    return positions;
}

double length_of(const std::vector<DrawnPoint>& points, std::size_t begin, std::size_t end) {
    double length = 0;
    for (std::size_t i = begin + 1; i < std::min(end, points.size()); ++i)
        length += (points[i].position - points[i - 1].position).norm();
    return length;
}

Vector2d outwards_at(const std::vector<DrawnPoint>& points, bool is_last, double reach) {
    const auto at = [&](std::size_t k) -> const Vector2d& {
        return points[is_last ? points.size() - 1 - k : k].position;
    };
    std::size_t k = 1;
    while (k + 1 < points.size() && (at(k) - at(0)).norm() < reach)
        ++k;
    return (at(0) - at(k)).stableNormalized();
}

void shift_end(std::vector<DrawnPoint>& points, bool is_last, const Vector2d& shift, double reach) {
    double length = 0;
    for (std::size_t k = 0; k < points.size() && length < reach; ++k) {
        const std::size_t i = is_last ? points.size() - 1 - k : k;
        const Vector2d before = points[i].position;
        points[i].position += (1 - length / reach) * shift;
        if (k + 1 < points.size())
            length += (points[is_last ? i - 1 : i + 1].position - before).norm();
    }
}

Eigen::AlignedBox2d box_of(const DrawnLine& line) {
    Eigen::AlignedBox2d box;
    for (const DrawnPoint& point : line.points)
        box.extend(point.position);
    return box;
}

bool is_fixed(const DrawnLine& line) {
    return std::all_of(line.points.begin(), line.points.end(),
                       [](const DrawnPoint& point) { return point.stays(); });
}

bool is_smooth(const DrawnLine& line) {
    double smooth = 0, exact = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const DrawnPoint &a = line.points[i - 1], &b = line.points[i];
        (a.is_exact && b.is_exact ? exact : smooth) += (b.position - a.position).norm();
    }
    return smooth > exact;
}

bool is_inner(const DrawnLine& line) {
    return (line.line_class == LineClass::Inner || line.line_class == LineClass::Fine) &&
           is_smooth(line);
}

Eigen::AlignedBox3d bounds_of(const TriangleMesh& mesh) {
    const std::size_t count = mesh.known_edge > 0 ? mesh.known_vertices : mesh.positions.size();
    Eigen::AlignedBox3d box;
    for (const laplacian_lines::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle)
            if (v < count && mesh.positions[v].allFinite()) box.extend(mesh.positions[v]);
    return box;
}

Eigen::AlignedBox3d bounds_of(const Objects& objects) {
    Eigen::AlignedBox3d box;
    for (const Object& object : objects)
        box.extend(bounds_of(object.mesh));
    return box;
}

DrawnLine project(const std::vector<Vector3d>& section, const Projection& projection, double unit) {
    DrawnLine drawn{
        LineClass::Section, section.size() > 3 && section.front() == section.back(), {}};
    for (const Vector3d& p : section)
        drawn.points.push_back({unit * projection(p), 1});
    return drawn;
}

std::vector<DrawnLine> project(const std::vector<ViewLine>& lines, const Projection& projection,
                               double unit) {
    std::vector<DrawnLine> drawn;
    for (const ViewLine& line : lines) {
        drawn.push_back({class_of(line), line.closed, {}, unit * double(line.jump), line.kind});
        drawn.back().points.reserve(line.points.size());
        for (const ViewLinePoint& point : line.points)
            drawn.back().points.push_back({unit * projection(point.position),
                                           width_of(point),
                                           point.node,
                                           point.is_exact,
                                           false,
                                           {projection.depth(point.position), line.kind,
                                            point.gradient, line.strength, line.slope}});
    }
    return drawn;
}

}  // namespace line_drawing
