// SPDX-License-Identifier: GPL-3.0-or-later
// Axes of the picture for a view, with the eye slightly turned, and the part of a mesh that is
// before the eye, by clipping at the near plane.
#include "visibility/eye_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

constexpr double kTurn = 3e-5;         // rad; any from 1e-7 to 1e-3 decides alike
constexpr double kIrregular = 0.7316;  // rad; of an axis that is none of a mesh's symmetry
constexpr double kFarthestEye = 1e8;   // D; farther off, rounding is more than perspective

/// A direction or position, turned about the origin. The origin has no direction: an eye there is
/// moved as far as one at the distance D would be.
Vector3d turned(const Vector3d& v) {
    if (v.isZero(0)) return kTurn * Vector3d(0.36, 0.48, 0.8);
    const Vector3d direction = v.stableNormalized(), aside = direction.unitOrthogonal();
    const Vector3d axis =
        std::cos(kIrregular) * aside + std::sin(kIrregular) * direction.cross(aside);
    return Eigen::AngleAxisd(kTurn, axis) * v;
}

}  // namespace

EyeFrame::EyeFrame(const VisibilityMesh& mesh, const View& view, bool looks_away) {
    Vector3d eye = view.eye - view.w * mesh.centre;  // local, but for a scale
    if (view.w != 0) eye /= view.w * mesh.size;
    has_perspective_ = view.w != 0 && eye.stableNorm() <= kFarthestEye;
    eye_ = turned(has_perspective_ ? eye : eye.stableNormalized());
    back_ = eye_.stableNormalized();
    if (looks_away) back_ = -back_;
    right_ = back_.unitOrthogonal();
    up_ = back_.cross(right_);
}

double EyeFrame::turn() {
    return kTurn;
}

Vector3d EyeFrame::project(const Vector3d& local) const {
    if (!has_perspective_) return {right_.dot(local), up_.dot(local), back_.dot(local)};
    const Vector3d from_eye = local - eye_;
    const double nearness = 1 / std::max(-back_.dot(from_eye), kLeastDepth);
    return {nearness * right_.dot(from_eye), nearness * up_.dot(from_eye), nearness};
}

bool is_before_eye(const VisibilityMesh& mesh, const EyeFrame& frame) {
    return !frame.has_perspective() || frame.depth(Vector3d::Zero()) > kMeshReach + kLeastDepth ||
           std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
               return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
                   return frame.depth(mesh.positions[v]) > kLeastDepth;
               });
           });
}

TriangleMesh part_before_eye(const VisibilityMesh& mesh, const EyeFrame& frame) {
    TriangleMesh part{mesh.positions, {}};
    const auto above = [&](std::uint32_t v) {
        return frame.depth(mesh.positions[v]) - kLeastDepth;
    };
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
        const double t = above(a) / (above(a) - above(b));
        part.positions.push_back(mesh.positions[a] + t * (mesh.positions[b] - mesh.positions[a]));
        return std::uint32_t(part.positions.size() - 1);
    };
    for (const Triangle& t : mesh.triangles) {
        std::vector<std::uint32_t> loop;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if (above(a) > 0) loop.push_back(a);
            if ((above(a) > 0) != (above(b) > 0)) loop.push_back(between(a, b));
        }
        for (std::size_t i = 2; i < loop.size(); ++i)
            part.triangles.push_back({loop[0], loop[i - 1], loop[i]});
    }
    return part;
}

}  // namespace laplacian_lines
