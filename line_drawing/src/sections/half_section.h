// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/object.h"
#include "planes/clipping.h"
#include "sections/axis_finding.h"
#include "views/drawn_view.h"

namespace line_drawing {

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
