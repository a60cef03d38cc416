// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fixed/triangle_graph.h"

namespace laplacian_lines {

/// How the surface turns along its section with a plane, to both sides of a point. Keeps its
/// capacity. Distances are along the section, local; to the one side they are negative. Angles are
/// those of the normal against the point's, degrees, and rise where the surface is convex.
class SectionProfile {
public:
    /// Beyond the ends of the section the surface goes on without a turn.
    float angle(float distance) const;
    Eigen::Vector3f position(float distance) const;
    /// Where half of the turn between −reach and reach is on either side.
    float middle(float reach) const;

private:
    friend class SectionProbe;
    struct Place {
        float distance;  // to its side, not negative
        float angle;     // positive where the surface is convex, to either side
        Eigen::Vector3f position;
    };
    using Side = std::vector<Place>;  // from the point on, which is among them

    const Side& side(float distance) const { return sides_[distance < 0 ? 0 : 1]; }

    Side sides_[2];
};

/// Walks over the surface from triangle to triangle. Thread-safe.
class SectionProbe {
public:
    /// The graph is kept by reference. `sign` is what angles are multiplied by: −1 for concave
    /// edges.
    explicit SectionProbe(const TriangleGraph& graph, float sign = 1)
        : graph_(graph), sign_(sign) {}

    /// A point on a side of a triangle, and the plane through it. Local coordinates.
    struct Section {
        TriangleSide side;
        Eigen::Vector3f point, normal;  ///< of the surface; the normal has any length
        Eigen::Vector3f across;         ///< in the plane, tangential, unit, to the positive side
    };
    /// As far as `reach` to both sides, if the surface does not end before.
    void measure(const Section& section, float reach, SectionProfile& profile) const;

private:
    const TriangleGraph& graph_;
    const float sign_;
};

}  // namespace laplacian_lines
