// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/prepared_mesh.h"
#include "mesh/spatial_tree.h"
#include "system/large_array.h"
#include "system/parallel.h"

namespace laplacian_lines {

constexpr double kQuickError = 8e-5;  ///< of a quick Gaussian, relative

/// Weight by the cosine between two normals ("Skip Opposite Sheet"): 1 for equal ones, 1/2 at a
/// right angle, 0 for opposite ones, flat at both ends, so that smooth surfaces keep their Δn up to
/// second order in h‖S‖². A polynomial, so that it can be summed over a grid as moments of the
/// normals.
inline double facing_weight(double cosine) {
    return (1 + cosine) * (1 + cosine) * (2 - cosine) / 4;
}

/// w(q) = m_q exp(−|q−p|²/4h) over the vertices q within `cutoff`·√h of p.
struct GaussianKernel {
    double size = 0;     ///< √h, local units
    double cutoff = 6;   ///< in √h
    bool facing = true;  ///< times facing_weight(n_q·n_p)
    bool quick = false;  ///< kQuickError will do
};

/// What the normal smoothing and Belkin's operator are made of, [N] each.
struct GaussianSums {
    explicit GaussianSums(std::size_t count)
        : mass(large_array<float>(count)),
          first_moment(large_array<Eigen::Vector3f>(count)),
          normal_difference(large_array<Eigen::Vector3f>(count)) {}

    std::vector<float> mass;                         ///< Σ w
    std::vector<Eigen::Vector3f> first_moment;       ///< Σ w (q − p)
    std::vector<Eigen::Vector3f> normal_difference;  ///< Σ w (n_q − n_p)
};

/// Direct summation in float, relative error about 1e-6 (kQuickError if quick) before the cutoff
/// truncates: positions and normals are relative to those of a leaf. `tree` is what sort_in_space()
/// returned for the mesh.
GaussianSums gaussian_sums(const PreparedMesh& mesh, const SpatialTree& tree,
                           const std::vector<Eigen::Vector3d>& normals,
                           const GaussianKernel& kernel, const StageProgress& stage);

struct GridResolution;  // summation_cost.h

/// As gaussian_sums() without cutoff, with the accuracy of the resolution, in a time that hardly
/// depends on the kernel size (R. W. Hockney and J. W. Eastwood, "Computer Simulation Using
/// Particles", 1981; the idea is from L. Greengard and J. Strain, "The Fast Gauss Transform",
/// 1991). Only nodes near the surface exist, and one slab of blocks is worked on after the other.
GaussianSums grid_sums(const PreparedMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                       const GaussianKernel& kernel, const GridResolution& resolution,
                       const StageProgress& stage);

}  // namespace laplacian_lines
