// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "visibility/box_tree.h"
#include "visibility/eye_frame.h"
#include "visibility/sight_mesh.h"

namespace laplacian_lines {

/// What is before and behind a point as seen from the eye.
struct Backing {
    bool is_hidden = false;
    /// To the next surface behind it, as the eye sees it, local; infinite if there is none.
    double gap = std::numeric_limits<double>::infinity();
};

/// A surface as it lies in the picture of one view. Thread-safe.
class Picture {
public:
    /// The mesh has to outlive it, and to be before a perspective eye.
    Picture(const SightMesh& mesh, const EyeFrame& frame, const StageProgress& stage);

    const SightMesh& mesh() const { return mesh_; }
    const EyeFrame& frame() const { return frame_; }
    const Eigen::Vector3d& vertex(std::uint32_t vertex) const { return places_[vertex]; }

    /// On which side of an edge, from its first vertex to its second, a triangle lies that has it:
    /// 1 left, −1 right.
    int side_of(const SightMesh::Side& side) const {
        return side.is_reversed ? -facing_[side.triangle] : facing_[side.triangle];
    }

    /// Whether all triangles of an edge are on one side of it.
    bool is_fold(std::uint32_t edge) const;

    /// 1 left of the line from a to b or on it, −1 right of it; opposite from b to a.
    static int turn(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

    /// How much larger z is of what is nearer to the eye by a small `distance`, local.
    double rise_of(double distance, double z) const {
        return frame_.has_perspective() ? distance * z * z : distance;
    }

    /// Where a share of the line between two places of the picture lies in space.
    double share_in_space(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double t) const {
        return frame_.has_perspective() ? t * to.z() / ((1 - t) * from.z() + t * to.z()) : t;
    }

    /// By a ray through a point of the surface, local, that passes over the triangles `own`, in
    /// their order, of which the point is part. What is no farther than `precision`, local, from
    /// the plane of a triangle is on it.
    Backing look(const Eigen::Vector3d& point, const SightMesh::Side* own, std::size_t own_count,
                 double precision) const;

private:
    bool covers(std::uint32_t triangle, const Eigen::Vector3d& place) const;

    const SightMesh& mesh_;
    const EyeFrame frame_;
    std::vector<Eigen::Vector3d> places_;
    std::vector<std::int8_t> facing_;  // of triangles: 1 if counter-clockwise in the picture
    BoxTree<2> tree_;                  // of triangles
};

}  // namespace laplacian_lines
