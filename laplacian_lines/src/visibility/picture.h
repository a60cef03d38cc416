// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "mesh/box_tree.h"
#include "visibility/eye_frame.h"
#include "visibility/sight_mesh.h"

namespace laplacian_lines {

/// A box of places in the picture by floats, rounded outwards.
template <int Dim>
Eigen::AlignedBox<float, Dim> box_outside(const Eigen::AlignedBox<double, Dim>& box) {
    const auto wider = [](const Eigen::Matrix<double, Dim, 1>& corner, float sign) {
        const auto f = corner.template cast<float>().array().eval();
        return Eigen::Matrix<float, Dim, 1>(f + sign * (2e-7f * f.abs() + 1e-12f));
    };
    return {wider(box.min(), -1), wider(box.max(), 1)};
}

/// What is before and behind a point.
struct Backing {
    bool is_hidden = false;
    /// From a point that is seen to the next surface behind it, local; infinite if there is none.
    double gap = std::numeric_limits<double>::infinity();
};

/// A surface in the picture of one view. Thread-safe.
class Picture {
public:
    /// The mesh outlives this and is before a perspective eye.
    Picture(const SightMesh& mesh, const EyeFrame& frame, const StageProgress& stage);

    const SightMesh& mesh() const { return mesh_; }
    const EyeFrame& frame() const { return frame_; }
    const Eigen::Vector3d& vertex(std::uint32_t vertex) const { return places_[vertex]; }

    /// On which side of an edge, from its first vertex to its second, its triangle lies: 1 left, −1
    /// right.
    int side_of(const SightMesh::Side& side) const {
        return side.is_reversed ? -facing_[side.triangle] : facing_[side.triangle];
    }

    /// All triangles of the edge are on one side of it.
    bool is_fold(std::uint32_t edge) const;

    /// 1 left of the line from a to b or on it, −1 right of it; the opposite from b to a.
    static int turn(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

    /// By how much z grows from there over a small local `distance` towards the eye.
    double rise_of(double distance, double z) const {
        return frame_.has_perspective() ? distance * z * z : distance;
    }

    /// z at a local distance behind a place, or less.
    double behind(double z, double distance) const {
        return frame_.has_perspective() ? z / (1 + distance * z) : z - distance;
    }

    /// The share in space of a share of the line between two places of the picture.
    double share_in_space(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double t) const {
        return frame_.has_perspective() ? t * to.z() / ((1 - t) * from.z() + t * to.z()) : t;
    }

    /// By a ray through a local point of the surface, which is part of the triangles `own`, in
    /// order; it ignores these. Points up to `precision`, local, from a triangle's plane are on it.
    /// `hider`: a triangle that is tried first, then the one that hides the point, if any does; the
    /// same mostly hides what is beside it.
    Backing look(const Eigen::Vector3d& point, const SightMesh::Side* own, std::size_t own_count,
                 double precision, std::uint32_t& hider) const;

private:
    bool covers(std::uint32_t triangle, const Eigen::Vector3d& place) const;

    const SightMesh& mesh_;
    const EyeFrame frame_;
    std::vector<Eigen::Vector3d> places_;
    std::vector<std::int8_t> facing_;  // of triangles: 1 if counter-clockwise in the picture
    BoxTree<3> tree_;                  // of triangles
};

}  // namespace laplacian_lines
