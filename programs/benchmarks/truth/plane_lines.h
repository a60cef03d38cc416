// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace benchmarks {

/// In a picture, mm, x right, y up.
using PlanePoint = Eigen::Vector2d;
using PlaneLine = std::vector<PlanePoint>;
using PlaneLines = std::vector<PlaneLine>;

inline double length_of(const PlaneLine& line) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        length += (line[i + 1] - line[i]).norm();
    return length;
}

/// Axes of a picture in mesh coordinates, orthonormal.
struct PlaneFrame {
    Eigen::Vector3d right, up, viewer;  ///< the last one towards the viewer

    PlanePoint project(const Eigen::Vector3d& p) const { return {p.dot(right), p.dot(up)}; }
};

/// Calls use(point, direction, length) at the middles of pieces of at most `step`.
template <class Use>
void for_each_piece(const PlaneLine& line, double step, Use use) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const PlanePoint way = line[i + 1] - line[i];
        const double length = way.norm();
        if (!(length > 0)) continue;
        const int count = std::max(1, int(std::ceil(length / step)));
        for (int k = 0; k < count; ++k)
            use(PlanePoint(line[i] + way * ((k + 0.5) / count)), PlanePoint(way / length),
                length / count);
    }
}

struct NearPlace {
    double distance = 0;
    PlanePoint foot, direction;  ///< direction: of the segment, of length 1
    std::size_t line = 0;        ///< its number
    double along = 0;            ///< from the line's begin, mm
    bool is_end = false;         ///< the foot is the begin or the end of its line
};

/// In a grid with cells as wide as the distance asked for.
class NearSegments {
public:
    NearSegments(const PlaneLines& lines, double reach);

    /// Calls use(NearPlace) for each segment within reach until it returns true; whether it did.
    template <class Use>
    bool any_near(const PlanePoint& p, Use use) const {
        const Cell middle = cell_of(p);
        for (std::int64_t x = -1; x <= 1; ++x)
            for (std::int64_t y = -1; y <= 1; ++y) {
                const auto found = cells_.find(key(middle + Cell(x, y)));
                if (found == cells_.end()) continue;
                for (const std::uint32_t number : found->second) {
                    const NearPlace place = nearest_on(segments_[number], p);
                    if (place.distance <= reach_ && use(place)) return true;
                }
            }
        return false;
    }

    /// To the nearest line; infinite beyond the reach.
    double distance(const PlanePoint& p) const;

private:
    using Cell = Eigen::Matrix<std::int64_t, 2, 1>;
    struct Segment {
        PlanePoint begin, way;
        double along;
        std::uint32_t line;
        bool is_first, is_last;
    };

    void add(const Segment& segment);
    static NearPlace nearest_on(const Segment& segment, const PlanePoint& p);
    Cell cell_of(const PlanePoint& p) const {
        return (p / reach_).array().floor().cast<std::int64_t>();
    }
    static std::uint64_t key(const Cell& c) {
        return (std::uint64_t(c.x()) << 32) | (std::uint64_t(c.y()) & 0xffffffff);
    }

    double reach_;
    std::vector<Segment> segments_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace benchmarks
