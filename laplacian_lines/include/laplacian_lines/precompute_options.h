// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

enum class LaplaceOperator {
    Belkin,     ///< heat kernel on the mesh, Belkin et al. 2008 (the paper's Eq. 2)
    Cotangent,  ///< cotangent weights; depends on the triangulation, kept for comparison (Fig. 2)
};

enum class NormalSmoothing { None, Gaussian };

enum class GradientEstimator {
    TriangleFit,   ///< curvature tensor fitted to each triangle, Rusinkiewicz 2004
    LeastSquares,  ///< fit in a ball (the paper's Eq. 3), solved in the tangent plane
};

/// The least automatic √h, in mean edges. Decimated scans have features one or two edges wide;
/// against noise, smoothing of normals is better than a larger kernel.
constexpr double kLeastKernelEdges = 1;

/// Options of the view-independent field; the defaults need no tuning per model. ē is the mean edge
/// length of the mesh, before refined(), D the diagonal of its bounding box. Names, limits and
/// help, but of the two for drawings, which programs set: option_table.h.
struct PrecomputeOptions {
    /// √h, mesh units; the Gaussian of Eq. 2 has the standard deviation √2·√h. 0: automatic,
    /// max(ē, 0.45 % of D), with 0.6 ē of refined() meshes; 2 % of D of CAD meshes with large
    /// triangles.
    double kernel_size = 0;
    /// For drawings at a given size: if > 0, √h in mesh units instead of kernel_size, but at least
    /// least_drawn_edges times ē, 0.6 ē or 2 % of D, as above, and at most 4 % of D or that. An
    /// automatic normal_sigma is then a quarter of √h or more, but 0 on such CAD meshes.
    double drawn_kernel_size = 0;
    double least_drawn_edges = kLeastKernelEdges;  ///< > 0, with drawn_kernel_size alone
    LaplaceOperator laplace_operator = LaplaceOperator::Belkin;
    /// Relative RMS error of Δn that summing the heat kernel may add; rounding ends at 4e-6.
    /// Smaller is slower.
    double accuracy = 1e-3;
    NormalSmoothing normal_smoothing = NormalSmoothing::Gaussian;
    /// Standard deviation of the smoothing, in ē. 0: automatic, none on CAD meshes with large
    /// triangles; else what noise asks for, or up to 0.8 of their own edges where triangles are
    /// finer than the kernel. None at all: NormalSmoothing::None.
    double normal_sigma = 0;
    GradientEstimator gradient_estimator = GradientEstimator::TriangleFit;
    double gradient_radius = 3.0;  ///< ball of the least squares fit, in mean edges
    bool correct_borders = true;   ///< make up for the half of the kernel a border lacks
    /// Weight sources q by (1 + c)²(2 − c)/4, c = n(p)·n(q): 1 for equal normals, 0 for opposite.
    bool skip_opposite_sheet = true;
    /// Merge vertices at one place, or up to 5e-5 D apart, where they cut the surface open: two
    /// borders, and no third one, run along each other in opposite directions. Also the ends of
    /// sides shorter than 1e-6 D and a thousandth of the mean edge.
    bool weld_duplicates = true;
    /// Also compute Field::curvature_derivatives and smooth_curvatures, for kinds that need them.
    bool curvature_derivatives = false;
};

/// @throws Error(InvalidOption) naming the first option that is out of range.
void validate(const PrecomputeOptions& options);

}  // namespace laplacian_lines
