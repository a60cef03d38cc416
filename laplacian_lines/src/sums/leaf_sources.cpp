// SPDX-License-Identifier: GPL-3.0-or-later
#include "sums/leaf_sources.h"

namespace laplacian_lines {

std::size_t find_near(const LeafPlaces& places, std::size_t count, const Eigen::Vector3f& shift,
                      const Eigen::Vector3f& half_size, float squared_reach,
                      std::uint32_t near[SpatialTree::kLeafSize]) {
    LeafPlaces::Row squared = LeafPlaces::Row::Zero();
    for (int k = 0; k < 3; ++k)
        squared += ((places.axes[k] + shift[k]).abs() - half_size[k]).max(0.f).square();
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; ++i) {
        near[found] = std::uint32_t(i);
        found += squared[Eigen::Index(i)] <= squared_reach;  // else the next overwrites it
    }
    return found;
}

}  // namespace laplacian_lines
