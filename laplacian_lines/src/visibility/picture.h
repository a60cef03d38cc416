// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "mesh/box_tree.h"
#include "visibility/eye_frame.h"
#include "visibility/visibility_mesh.h"

namespace laplacian_lines {

/// A box of points in the picture, rounded outwards to floats: 2e-7 is more than two roundings.
template <int Dim>
Eigen::AlignedBox<float, Dim> box_outside(const Eigen::AlignedBox<double, Dim>& box) {
    const auto wider = [](const Eigen::Matrix<double, Dim, 1>& corner, float sign) {
        const auto f = corner.template cast<float>().array().eval();
        return Eigen::Matrix<float, Dim, 1>(f + sign * (2e-7f * f.abs() + 1e-12f));
    };
    return {wider(box.min(), -1), wider(box.max(), 1)};
}

/// What a ray from the eye through a point meets before and behind it.
struct RayHits {
    bool is_hidden = false;
    /// From a point that is seen to the next surface behind it, local; infinite if there is none.
    double gap = std::numeric_limits<double>::infinity();
};

/// A surface projected to the picture of a view. Thread-safe.
class Picture {
public:
    /// The mesh outlives this and is in front of a perspective eye.
    Picture(const VisibilityMesh& mesh, const EyeFrame& frame, const StageProgress& stage);

    const VisibilityMesh& mesh() const { return mesh_; }
    const EyeFrame& frame() const { return frame_; }
    /// Its place in the picture, as of EyeFrame::project().
    const Eigen::Vector3d& vertex(std::uint32_t vertex) const { return places_[vertex]; }

    /// On which side of an edge, from its first vertex to its second, its triangle lies: 1 left, −1
    /// right.
    int side_of(const VisibilityMesh::Side& side) const {
        return side.is_reversed ? -facing_[side.triangle] : facing_[side.triangle];
    }

    /// Whether all triangles of an edge are on one side of it.
    bool is_contour(std::uint32_t edge) const;

    /// Orientation of c to the line from a to b: 1 left of it, −1 right of it, either on it.
    /// Exchanging a and b, which are not the same, changes the sign.
    static int turn(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

    /// By how much z grows over a small local distance towards the eye, from this z on.
    double rise_of(double distance, double z) const {
        return frame_.has_perspective() ? distance * z * z : distance;
    }

    /// A lower bound of z at a local distance behind a point.
    double behind(double z, double distance) const {
        return frame_.has_perspective() ? z / (1 + distance * z) : z - distance;
    }

    /// Converts a share of the line between two points of the picture to the share in space.
    double share_in_space(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double t) const {
        return frame_.has_perspective() ? t * to.z() / ((1 - t) * from.z() + t * to.z()) : t;
    }

    /// Casts a ray through a local point of the surface, ignoring the triangles `own` (ascending)
    /// that contain it. Points up to `precision`, local, from a triangle's plane are on it.
    /// `occluder`: in, a triangle to test first; out, the one that hides the point, if any.
    /// Neighbouring points mostly have the same.
    RayHits cast_ray(const Eigen::Vector3d& point, const VisibilityMesh::Side* own,
                     std::size_t own_count, double precision, std::uint32_t& occluder) const;

private:
    bool covers(std::uint32_t triangle, const Eigen::Vector3d& place) const;

    const VisibilityMesh& mesh_;
    const EyeFrame frame_;
    std::vector<Eigen::Vector3d> places_;
    std::vector<std::int8_t> facing_;  // of triangles: 1 if counter-clockwise in the picture
    BoxTree<3> tree_;                  // of triangles
};

}  // namespace laplacian_lines
