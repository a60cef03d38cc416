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
/// those of the normal against the point's, degrees, and rise where the surface is convex.
class SectionProfile {
public:
    /// Walks over the surface from triangle to triangle, as far as `reach` to both sides, if it
    /// does not end before. `sign` is what angles are multiplied by: −1 for concave edges.
    void measure(const Surface& surface, const Section& section, float sign, float reach);

    /// Beyond the ends of the section the surface goes on without a turn.
    float angle(float distance) const;
    Eigen::Vector3f position(float distance) const;
    /// Where half of the turn between −reach and reach is on either side.
    float middle(float reach) const;

private:
    struct Place {
        float distance, angle;
        Eigen::Vector3f position;
    };
    template <class Read>
    auto interpolate(float distance, Read read) const;

    std::vector<Place> places_;  // along the section
};

}  // namespace laplacian_lines
