// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/object.h"
#include "planes/clipping.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// The axis of a vessel, and what speaks for it.
struct VesselAxis {
    Eigen::Vector3d point;  ///< in mesh coordinates; its own place along the axis is 0
    double round = 0;       ///< share of what faces sideways whose normals meet the axis, nearly
    double lean = 0;        ///< degrees by which the vessel's own axis stands off
    double rim = 0;         ///< share of the way around the axis with surface in the upper tenth
};

/// The axis around which a vessel was thrown, which points in the direction of the
/// mesh's axis `up`: the normals of a surface of revolution meet its axis. Handles and spouts, of
/// which fewer do, count little. Through the middle of the bounding box where normals tell nothing.
/// `looks_up`: whether the vessel stands upright along that axis, or upside down.
///
/// Source: the linear complex of normals, H. Pottmann, T. Randrup, "Rotational and helical surface
/// approximation for reverse engineering", Computing 60 (1998), with iterated weights.
VesselAxis findAxis(const laplacian_lines::TriangleMesh& mesh, int up, bool looks_up = true);

/// The planes of the half section of a vessel: upright, through its axis.
class HalfSection {
public:
    /// For the objects with the joined surface `all`; `frame` has to look along an axis of the
    /// mesh. The objects have to outlive it.
    HalfSection(const Objects& objects, const laplacian_lines::TriangleMesh& all,
                const ViewFrame& frame);

    /// @throws laplacian_lines::Error(InvalidOption) if the axis found is none of a vessel.
    void expectVessel() const;
    /// What speaks for the axis, for notes: "rim 62 %, axis off by 1.5°".
    std::string words() const;

    HalfSpace behind() const { return behind_; }
    HalfSpace left() const { return right_.opposite(); }
    HalfSpace right() const { return right_; }

    /// Adds to a view the section, the axis and the lines through rim and base. Lines of the view
    /// that show through the wall are taken away. `unit` as in project(), `middle` as in
    /// Projection.
    void draw(DrawnView& drawn, const Eigen::Vector3d& middle, double unit) const;

private:
    const Objects& objects_;
    const VesselAxis axis_;
    HalfSpace behind_, right_;
};

}  // namespace line_drawing
