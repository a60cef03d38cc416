// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analytic_surface.h"
#include "laplacian_lines/view.h"
#include "visibility/ray_caster.h"

namespace benchmarks {

/// A smooth surface that is known at each of its points, and what of it an eye that is infinitely
/// far away sees: by rays against a mesh of it that is much finer than any that lines are drawn on.
class SightTruth {
public:
    using Foot = std::function<test_meshes::SurfacePoint(const Eigen::Vector3d&)>;

    /// `foot` is the point of the surface at a place near it.
    SightTruth(const laplacian_lines::TriangleMesh& fine, Foot foot);

    struct Contour {
        bool is_seen;
        double
            radial;  ///< curvature towards the eye, a share of how much normals turn there; 0: cusp
    };

    /// The contour near a place; none if there is none within `reach`.
    std::optional<Contour> contour_at(const Eigen::Vector3d& place,
                                      const Eigen::Vector3d& towards_eye, double reach) const;

private:
    laplacian_lines::RayCaster caster_;
    Foot foot_;
};

/// A form with meshes of growing fineness.
struct KnownForm {
    std::string name;
    std::vector<std::function<laplacian_lines::TriangleMesh()>> meshes;
    std::function<SightTruth()> truth;
};
/// Torus, peanut, bumpy sphere.
std::vector<KnownForm> known_forms();

}  // namespace benchmarks
