// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fixed/surface.h"

namespace laplacian_lines {

/// A point on a side of Surface, and a plane through it. Local coordinates.
struct Section {
    std::uint32_t side;
    Eigen::Vector3f point, normal;  ///< of the surface; the normal has any length
    Eigen::Vector3f across;         ///< in the plane, tangential, unit, to the positive side
};

/// How the surface turns along its section with a plane, to both sides of a point. Keeps its
/// capacity. Distances are along the section, local; to the one side they are negative. Angles are
/// those of the normal against the point's, degrees, beyond 180 too; they rise where it is convex.
class SectionProfile {
public:
    /// Walks over the surface from triangle to triangle of one orientation, up to `reach` to both
    /// sides or to a border. `sign`: factor of the angles, −1 for concave edges.
    void measure(const Surface& surface, const Section& section, float sign, float reach);

    /// Constant beyond the ends of the section.
    float angle(float distance) const;

    /// The largest turn on the way there, 0 or more: of angle() if `distance` is positive, of
    /// −angle() if it is negative.
    float largest_turn(float distance) const;

private:
    struct Place {
        float distance, angle;
    };
    std::vector<Place> places_;  // along the section
};

}  // namespace laplacian_lines
