// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"
#include "planes/cutting.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// A vessel's axis, and the evidence for it.
struct VesselAxis {
    Eigen::Vector3d point;  ///< in mesh coordinates; its own place along the axis is 0
    double round = 0;       ///< share of what faces sideways whose normals meet the axis, nearly
    double lean = 0;        ///< degrees by which the vessel's own axis stands off
    double rim = 0;         ///< share of the way around the axis with surface in the upper tenth
};

/// Planes through the axis of a vessel.
class HalfSection {
public:
    /// `all` is the objects' joined surface; `frame` looks along a mesh axis.
    HalfSection(const laplacian_lines::TriangleMesh& all, const ViewFrame& frame);

    /// @throws laplacian_lines::Error(InvalidOption) if the axis is not that of a vessel
    void expect_vessel() const;
    /// Evidence for the axis, for notes: "rim 62 %, axis off by 1.5°".
    std::string words() const;

    HalfSpace behind() const { return behind_; }
    HalfSpace left() const { return right_.opposite(); }
    HalfSpace right() const { return right_; }

    /// Adds the section, the axis and the lines through rim and base to a view, and removes lines
    /// that show through the objects' walls. `unit` as in project(), `middle` as in Projection.
    void draw(DrawnView& drawn, const std::vector<CuttableMesh>& objects,
              const Eigen::Vector3d& middle, double unit) const;

private:
    const VesselAxis axis_;
    HalfSpace behind_, right_;
};

}  // namespace line_drawing
