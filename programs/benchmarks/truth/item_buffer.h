// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "flat_drawing.h"

namespace benchmarks {

constexpr double item_pixels_per_mm = 20;

/// For each pixel, the number of the triangle in front.
class ItemBuffer {
public:
    /// In the coordinates of drawings_of(). @throws std::runtime_error beyond 1e8 pixels
    ItemBuffer(const laplacian_lines::TriangleMesh& mesh, const PlaneFrame& frame,
               const DrawingSetup& setup);

    /// Between neighbouring pixels of which one is background.
    PlaneLine border() const;
    /// Between neighbouring pixels whose depths jump by more than `least` mm, but not beside
    /// triangles seen edge-on.
    PlaneLine jumps(double least) const;

    bool is_covered(int x, int y) const { return items_[index(x, y)] != nothing; }
    int width() const { return width_; }
    int height() const { return height_; }
    PlanePoint place(double x, double y) const;  ///< of a pixel's middle
    /// Towards the viewer, mm; none over the background.
    std::optional<double> depth_at(const PlanePoint& place) const;

private:
    static constexpr std::uint32_t nothing = 0xffffffff;
    /// Depth of a triangle, towards the viewer: at pixel (0, 0), and per pixel.
    struct Plane {
        double at_origin = 0, by_x = 0, by_y = 0;
        bool is_known = false;  ///< not of what is seen from its edge
        double at(double x, double y) const { return at_origin + by_x * x + by_y * y; }
    };

    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width_) + std::size_t(x);
    }
    void fill(std::uint32_t item, const Eigen::Matrix3d& corners);
    void trace(std::uint32_t item, const Eigen::Vector3d& a, const Eigen::Vector3d& b);
    void cover(std::uint32_t item, int x, int y, double depth);
    bool is_jump(int x, int y, int right, int up, double least) const;
    template <class Test>
    PlaneLine between_pixels(Test test) const;

    PlanePoint corner_;
    int width_ = 0, height_ = 0;
    std::vector<std::uint32_t> items_;
    std::vector<float> depths_;
    std::vector<Plane> planes_;  ///< by triangle
};

/// Places between pixels; adds up over drawings.
struct SilhouetteScores {
    std::size_t border = 0;       ///< between surface and background
    std::size_t bare_border = 0;  ///< of it, without a line within .15 mm
    std::size_t far_border = 0;   ///< of it, without a line within .8 mm
    std::size_t jumps = 0;        ///< of depth, by more than .5 mm
    std::size_t bare_jumps = 0;

    /// The share of the border within .8 mm of a line.
    double share() const { return border ? 1 - double(far_border) / double(border) : 1; }
    void add(const SilhouetteScores& other);
};

/// Without a line within .15 mm.
struct BarePlaces {
    PlaneLine border, jumps;
};

SilhouetteScores score_silhouette(const ItemBuffer& items, const DrawnPaths& drawing,
                                  BarePlaces* bare = nullptr);

}  // namespace benchmarks
