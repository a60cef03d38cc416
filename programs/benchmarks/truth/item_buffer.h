// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/view_frame.h"
#include "plane_lines.h"

namespace benchmarks {

/// For each pixel, the number of the triangle in front: what a drawing has to go around, found in
/// another way than its lines.
class ItemBuffer {
public:
    static constexpr double kPixelsPerMm = 20;

    /// In the coordinates of drawings_of().
    ItemBuffer(const laplacian_lines::TriangleMesh& mesh, const line_drawing::ViewFrame& frame);

    /// Between neighbouring pixels of which one is background.
    PlaneLine border() const;
    /// Between neighbouring pixels whose depths jump by more than `least` mm, but not beside
    /// triangles seen edge-on.
    PlaneLine jumps(double least) const;

private:
    /// Depth of a triangle, towards the viewer: at pixel (0, 0), and per pixel.
    struct Plane {
        double at_origin = 0, by_x = 0, by_y = 0;
        bool is_known = false;  ///< not of what is seen from its edge
        double at(double x, double y) const { return at_origin + by_x * x + by_y * y; }
    };

    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width_) + x; }
    void fill(std::uint32_t item, const Eigen::Matrix3d& corners);
    template <class Test>
    PlaneLine between_pixels(Test test) const;

    Eigen::Vector2d corner_;
    int width_ = 0, height_ = 0;
    std::vector<std::uint32_t> items_;
    std::vector<double> depths_;
    std::vector<Plane> planes_;  ///< by triangle
};

/// Those without a line within `tolerance` mm.
PlaneLine bare_places(const PlaneLine& places, const PlaneLines& drawing, double tolerance);

}  // namespace benchmarks
