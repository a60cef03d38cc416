// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/object.h"
#include "planes/clipping.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// The planes of the half section of a vessel: upright, through its axis.
class HalfSection {
public:
    /// Of the objects with the joined surface `all`; `frame` has to look along an axis of the
    /// mesh. The objects have to outlive it.
    HalfSection(const Objects& objects, const laplacian_lines::TriangleMesh& all,
                const ViewFrame& frame);

    HalfSpace behind() const { return behind_; }
    HalfSpace left() const { return right_.opposite(); }
    HalfSpace right() const { return right_; }

    /// Adds to a view the section, the axis and the lines through rim and base. Lines of the view
    /// that show through the wall are taken away. `unit` as in project(), `middle` as in
    /// Projection.
    void draw(DrawnView& drawn, const Eigen::Vector3d& middle, double unit) const;

private:
    const Objects& objects_;
    const Eigen::Vector3d axis_;
    HalfSpace behind_, right_;
};

}  // namespace line_drawing
