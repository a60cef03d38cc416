// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace benchmarks {

/// In a picture, mm, x right, y up.
using PlanePoint = Eigen::Vector2d;
using PlaneLine = std::vector<PlanePoint>;
using PlaneLines = std::vector<PlaneLine>;

double length_of(const PlaneLine& line);

/// Calls use(begin, end) for pieces of at most `step`.
template <class Use>
void for_each_piece(const PlaneLine& line, double step, Use use) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const PlanePoint way = line[i + 1] - line[i];
        const int count = int(std::ceil(way.norm() / step));
        for (int k = 0; k < count; ++k)
            use(PlanePoint(line[i] + way * k / count), PlanePoint(line[i] + way * (k + 1) / count));
    }
}

struct NearPlace {
    std::size_t line = 0;  ///< its number
    double along = 0;      ///< from the line's begin, mm
};

/// In a grid with cells as wide as the distance asked for.
class NearSegments {
public:
    NearSegments(const PlaneLines& lines, double reach);

    /// Calls use(NearPlace) for each segment within reach until it returns true; whether it did.
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
                        use(NearPlace{segment.line, segment.along + t * segment.way.norm()}))
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
        PlanePoint begin, way;
        double along;
        std::size_t line;
        PlanePoint at(double t) const { return begin + t * way; }
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

}  // namespace benchmarks
