// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

enum class KernelMode {
    Uniform,   ///< one kernel size for the whole mesh
    Adaptive,  ///< √h(p) follows the local edge length, see PrecomputeOptions::kernel_mode
};

enum class LaplaceOperator {
    Belkin,     ///< heat kernel on the mesh, Belkin et al. 2008 (the paper's Eq. 2)
    Cotangent,  ///< cotangent weights; depends on the triangulation, kept for comparison (Fig. 2)
};

enum class NormalWeighting {
    Area,   ///< triangle area
    Angle,  ///< corner angle
    Max,    ///< sin(angle) / (product of the two edge lengths), Max 1999
};

enum class NormalSmoothing { None, Gaussian, Bilateral };

enum class GradientEstimator {
    TriangleFit,   ///< curvature tensor fitted to each triangle, Rusinkiewicz 2004
    LeastSquares,  ///< fit in a ball (the paper's Eq. 3), solved in the tangent plane
};

/// Everything that decides the view-independent field. The defaults are those of the drawings in
/// the README and are not meant to be tuned per model. "Mean edge" is the mean edge length ē of
/// the mesh, D the diagonal of its bounding box. Option names, limits and help texts for user
/// interfaces are in option_table.h.
struct PrecomputeOptions {
    /// √h, a length in mesh units (h itself is a squared length; the Gaussian of Eq. 2 has the
    /// standard deviation √2·√h). 0 means automatic: max(2 ē, 0.45 % of D).
    double kernel_size = 0;
    /// If > 0, the √h, mesh units, that a drawing at a certain size asks for, instead of
    /// kernel_size. Used within drawn_kernel_range(); an automatic normal_sigma is at least a
    /// quarter of it then.
    double drawn_kernel_size = 0;
    /// Adaptive: √h(p) = √h · clamp(ē(p)/ē, 1/4, 4), with ē(p) the mean length of the edges at p,
    /// averaged over one-rings ten times. Normal smoothing scales by the same factor.
    KernelMode kernel_mode = KernelMode::Uniform;
    LaplaceOperator laplace_operator = LaplaceOperator::Belkin;
    /// Relative error of Δn, root mean square over the mesh, that summing the heat kernel may add,
    /// 1e-6..0.1 (rounding ends at 4e-6). Smaller is slower.
    double accuracy = 1e-3;
    NormalWeighting normal_weighting = NormalWeighting::Area;
    NormalSmoothing normal_smoothing = NormalSmoothing::Gaussian;
    /// Standard deviation of the smoothing, in mean edges. 0 means automatic: 0.8, and up to 2.5 on
    /// rough meshes, see automatic_normal_sigma(). NormalSmoothing::None is no smoothing.
    double normal_sigma = 0;
    double bilateral_angle = 20.0;  ///< degrees between normals at which bilateral weights fade
    GradientEstimator gradient_estimator = GradientEstimator::TriangleFit;
    double gradient_radius = 3.0;  ///< ball of the least squares fit, in mean edges
    bool correct_borders = true;   ///< make up for the half of the kernel a border lacks
    /// Weight sources q by (1 + c)²(2 − c)/4, c = n(p)·n(q): 1 for equal normals, 0 for opposite.
    bool skip_opposite_sheet = true;
    /// Vertices of equal coordinates count as one where they cut the surface open: two borders run
    /// along each other there, in opposite directions, and no third one.
    bool weld_duplicates = true;
    /// Compute Field::curvature_derivatives and smooth_curvatures as well, which only some kinds of
    /// lines need.
    bool curvature_derivatives = false;
};

/// The automatic √h. Lengths in any unit; the result has the same one.
double automatic_kernel_size(double mean_edge, double diagonal);

/// √h in widths of the lines inside a form that is drawn at a size: finer detail clots, coarser
/// kernels lose what can be drawn.
constexpr double kDrawnKernelWidths = 4;

/// The kernel sizes that a drawing at any size may have: from 2 ē, since the mesh has no more
/// detail, to 4 % of D, or 2 ē where that is more. Lengths as above.
struct KernelRange {
    double least, most;
};
KernelRange drawn_kernel_range(double mean_edge, double diagonal);

/// The automatic smoothing of normals in mean edges, given MeshReport::roughness.
double automatic_normal_sigma(double roughness);

/// @throws Error(InvalidOption) naming the first option that is out of range.
void validate(const PrecomputeOptions& options);

}  // namespace laplacian_lines
