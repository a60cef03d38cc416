// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "depth_picture.h"
#include "laplacian_lines/line_set.h"
#include "picture_camera.h"
#include "pixel_mask.h"

namespace benchmarks {

/// Where weight times opacity is less, a line is not seen on paper.
constexpr double kLeastInk = 0.1;

/// Calls `use` with places along a segment that are half a pixel apart at most, both ends among
/// them: with the share of the way, and with column, row and depth.
void for_each_place(const PictureCamera& camera, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& to,
                    const std::function<void(double, const Eigen::Vector3d&)>& use);

/// The pixels that the middles of lines pass, where there is enough ink.
PixelMask line_pixels(const PictureCamera& camera, const laplacian_lines::LineSet& lines);

/// The same where a redraw shows them: where no surface lies nearer than a line by more than
/// sight_clearance() of its kind, of a mesh with this D and `sight_edge`.
PixelMask line_pixels_in_sight(const PictureCamera& camera, const DepthPicture& surface,
                               const laplacian_lines::LineSet& lines, double diagonal,
                               double sight_edge);

struct EdgeEnds {
    Eigen::Vector3d from, to;
};

/// The edges at which just two triangles meet whose normals differ by `degrees` and more, whichever
/// way round they are. Vertices at one place are one, as in files that repeat them.
std::vector<EdgeEnds> sharp_edges(const laplacian_lines::TriangleMesh& mesh, double degrees);

/// The pixels of edges where no surface lies nearer than an edge by more than `clearance`, in mesh
/// units.
PixelMask edge_pixels(const PictureCamera& camera, const DepthPicture& surface,
                      const std::vector<EdgeEnds>& edges, double clearance);

}  // namespace benchmarks
