// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"

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

}  // namespace line_drawing
