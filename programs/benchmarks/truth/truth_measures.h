// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/view_frame.h"

namespace benchmarks {

/// In a picture, mm, x right, y up.
using PlanePoint = Eigen::Vector2d;
using PlaneLine = std::vector<PlanePoint>;
using PlaneLines = std::vector<PlaneLine>;

/// Calls use(begin, end) for pieces of at most `step`.
template <class Use>
void for_each_piece(const PlaneLine& line, double step, Use use) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const PlanePoint span = line[i + 1] - line[i];
        const int count = int(std::ceil(span.norm() / step));
        for (int k = 0; k < count; ++k)
            use(PlanePoint(line[i] + span * k / count),
                PlanePoint(line[i] + span * (k + 1) / count));
    }
}

struct NearPlace {
    std::size_t line = 0;  ///< its number
    double along = 0;      ///< from the line's begin, mm
};

/// Finds segments near a point, by a grid with cells as wide as the distance.
class NearSegments {
public:
    NearSegments(const PlaneLines& lines, double reach);

    /// Calls use(NearPlace) for each segment within reach, some more than once, until it returns
    /// true; whether it did.
    template <class Use>
    bool any_near(const PlanePoint& p, Use use) const {
        const Cell middle = cell_of(p);
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y) {
                const auto found = cells_.find(key(middle + Cell(x, y)));
                if (found == cells_.end()) continue;
                for (const std::uint32_t number : found->second) {
                    const Segment& segment = segments_[number];
                    const double t = nearest_on(segment, p);
                    if ((p - segment.at(t)).norm() <= reach_ &&
                        use(NearPlace{segment.line, segment.along + t * segment.span.norm()}))
                        return true;
                }
            }
        return false;
    }
    bool has_near(const PlanePoint& p) const {
        return any_near(p, [](const NearPlace&) { return true; });
    }

private:
    using Cell = Eigen::Vector2i;
    struct Segment {
        PlanePoint begin, span;
        double along;
        std::size_t line;
        PlanePoint at(double t) const { return begin + t * span; }
    };

    void add(const Segment& segment);
    static double nearest_on(const Segment& segment, const PlanePoint& p);
    Cell cell_of(const PlanePoint& p) const { return (p / reach_).array().floor().cast<int>(); }
    static std::uint64_t key(const Cell& c) {
        return (std::uint64_t(c.x()) << 32) | std::uint32_t(c.y());
    }

    double reach_;
    std::vector<Segment> segments_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

struct PartMesh {
    double linear = 0, angular = 0;  ///< deflections, mm and rad
    laplacian_lines::TriangleMesh mesh;
};

/// Exact visible lines of a part from one direction, by OpenCASCADE.
struct ExactView {
    line_drawing::ViewFrame frame;
    PlaneLines required;  ///< have to be drawn
    PlaneLines allowed;   ///< tangent edges, which may be drawn
};

/// A CAD part. Its file is packed by zlib, behind the length of what is packed; numbers have the
/// lowest byte first, lists their length before them: "LLTRUTH1"; meshes: deflections, vertices as
/// three floats, triangles; views: name, a number to ignore, right, up and towards the viewer as
/// doubles, required and allowed lines, whose points are integers, steps from the last point in
/// 1/1000 mm.
struct CadPart {
    std::string name;
    std::vector<PartMesh> meshes;
    std::vector<ExactView> views;
};

/// @throws std::runtime_error with the file's name
CadPart read_part(const std::string& file);

inline PlanePoint project(const Eigen::Vector3d& p, const line_drawing::ViewFrame& frame) {
    return {p.dot(frame.right), p.dot(frame.up)};
}

/// Measured drawings at 1:1 of contours, borders and creases with plain strokes: for each frame the
/// lines in its coordinates, curves to .002 mm. @throws laplacian_lines::Error
std::vector<PlaneLines> drawings_of(const laplacian_lines::TriangleMesh& mesh,
                                    const std::vector<line_drawing::ViewFrame>& frames);

/// For each pixel, the number of the triangle in front: the silhouette and depth jumps,
/// independently of the drawing's lines.
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
        bool is_known = false;  ///< false for triangles seen edge-on
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

/// The places without a line within `tolerance` mm.
PlaneLine bare_places(const PlaneLine& places, const PlaneLines& drawing, double tolerance);

/// Scores of one drawing; lengths in mm.
struct TruthScores {
    double recall = 1;         ///< the share of the exact lines that is drawn
    double precision = 1;      ///< the share of the drawing that is near an exact line
    int ends = 0;              ///< of open paths
    PlaneLines missed, wrong;  ///< in small pieces
    PlaneLine loose_ends;      ///< at no other path, or part of their own, and at no end of
                               ///< a required line
};

/// Lines may be `tolerance` mm off, and ends .5 mm and `slack`, for coarse meshes, from true ones.
/// Those that are `allowed` need not be drawn.
TruthScores score(const PlaneLines& drawing, const PlaneLines& required, const PlaneLines& allowed,
                  double tolerance, double slack = 0);

}  // namespace benchmarks
