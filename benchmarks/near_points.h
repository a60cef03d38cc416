// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace benchmarks {

/// Points in a grid of cells as wide as the distance that is asked for.
class NearPoints {
public:
    NearPoints(const std::vector<Eigen::Vector3d>& points, double reach) : reach_(reach) {
        for (const Eigen::Vector3d& p : points)
            cells_[key(cell_of(p))].push_back(p);
    }

    /// Whether one of the points is that near.
    bool has(const Eigen::Vector3d& p) const {
        const Cell cell = cell_of(p);
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if (has(cell + Cell(x, y, z), p)) return true;
        return false;
    }

private:
    using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

    bool has(const Cell& cell, const Eigen::Vector3d& p) const {
        const auto found = cells_.find(key(cell));
        if (found == cells_.end()) return false;
        for (const Eigen::Vector3d& q : found->second)
            if ((p - q).squaredNorm() <= reach_ * reach_) return true;
        return false;
    }
    Cell cell_of(const Eigen::Vector3d& p) const {
        return (p / reach_).array().floor().cast<std::int64_t>();
    }
    /// The same for cells that are 2^21 apart: `has()` measures.
    static std::uint64_t key(const Cell& c) {
        return (std::uint64_t(c.x() & 0x1fffff) << 42) | (std::uint64_t(c.y() & 0x1fffff) << 21) |
               std::uint64_t(c.z() & 0x1fffff);
    }

    double reach_;
    std::unordered_map<std::uint64_t, std::vector<Eigen::Vector3d>> cells_;
};

}  // namespace benchmarks
