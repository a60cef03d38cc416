// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "laplacian_lines/triangle_mesh.h"
#include "planes/clipping.h"
#include "planes/cutting.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// A vessel's axis, and how certain it is.
struct VesselAxis {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the axis, mesh coordinates; its
                                                      ///< coordinate along the axis is 0
    double round = 0;  ///< share of the sideways area whose normals about meet the axis
    /// Angle of the vessel's own axis to the mesh's, degrees; none if it is not told from others,
    /// as of flutes.
    std::optional<double> lean;
    std::optional<int> other;  ///< the axis of the mesh along which the vessel stands, if not this
    double rim = 0;            ///< share of the directions with surface in the upper tenth
};

/// Planes through the axis of a vessel.
class HalfSection {
public:
    /// `all` is the objects' joined surface; `frame` looks along a mesh axis.
    HalfSection(const laplacian_lines::TriangleMesh& all, const ViewFrame& frame);

    /// @throws laplacian_lines::Error(InvalidOption) if the axis is not that of a vessel
    void expect_vessel() const;
    /// Text for notes: "rim 62 %, axis off by 1.5°".
    std::string words() const;

    /// Bounded by planes through the axis: behind it, and to either side of it in the view.
    HalfSpace behind() const { return behind_; }
    HalfSpace left() const { return right_.opposite(); }
    HalfSpace right() const { return right_; }

    /// Adds the section, the axis and the lines through rim and base to a view, and removes lines
    /// within the objects' walls. `unit` as in project(), `middle` as in Projection.
    void draw(DrawnView& drawn, const std::vector<CuttableMesh>& objects,
              const Eigen::Vector3d& middle, double unit) const;

private:
    const VesselAxis axis_;
    HalfSpace behind_, right_;
};

}  // namespace line_drawing
