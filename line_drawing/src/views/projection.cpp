// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/projection.h"

namespace line_drawing {

using Eigen::Vector2d;
using Eigen::Vector3d;
using laplacian_lines::SightLine;
using laplacian_lines::TriangleMesh;

/// Half width of a perspective view at distance 1: 60 degrees.
constexpr double tangent_of_sight = 1.7320508075688772;

Projection::Projection(const ViewFrame& frame, const Vector3d& middle)
    : frame_(frame), origin_(frame.eye.value_or(middle)) {
    if (!frame.eye) return;
    const Vector3d ray = middle - origin_;
    distance_ = depth(middle) > 0 ? depth(middle) : ray.norm();
    if (depth(middle) > 0) middle_ = {frame.right.dot(ray), frame.up.dot(ray)};
}

double Projection::depth(const Vector3d& p) const {
    return -frame_.towards_viewer.dot(p - origin_);
}

Vector2d Projection::operator()(const Vector3d& p) const {
    const Vector2d flat(frame_.right.dot(p - origin_), frame_.up.dot(p - origin_));
    return frame_.eye ? Vector2d(distance_ / depth(p) * flat - middle_) : flat;
}

Eigen::AlignedBox2d Projection::boundsOf(const TriangleMesh& mesh) const {
    const Vector2d reach = Vector2d::Constant(tangent_of_sight * distance_);
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

std::vector<SightLine> Projection::inSight(std::vector<SightLine> lines) const {
    if (!frame_.eye) return lines;
    for (const Vector3d& aside :
         {frame_.right, frame_.up, Vector3d(-frame_.right), Vector3d(-frame_.up)}) {
        const Vector3d normal = -tangent_of_sight * frame_.towards_viewer - aside;
        lines = clip(lines, {normal, normal.dot(origin_)});
    }
    return lines;
}

laplacian_lines::View Projection::view() const {
    return frame_.eye ? laplacian_lines::View::perspective(*frame_.eye)
                      : laplacian_lines::View::orthographic(frame_.towards_viewer);
}

}  // namespace line_drawing
