// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the field and of lines. The order is that of dialogs.
#include "laplacian_lines/option_rows.h"

namespace laplacian_lines {
using namespace option_rows;

const std::vector<OptionRow<PrecomputeOptions>>& precompute_option_table() {
    using O = PrecomputeOptions;
    static const std::vector<OptionRow<O>> table = {
        row<&O::kernel_size>("kernel_size", "Kernel Size", OptionKind::Length, 0, kUnlimited,
                             "Size of the features that the lines show, &radic;h, in mesh units: "
                             "larger gives fewer and smoother lines. 0 means automatic: the mean "
                             "edge, but at least 0.45 % of the diagonal; 2 % of it on CAD "
                             "meshes with large triangles."),
        choice<&O::laplace_operator>(
            "laplace_operator", "Laplace Operator", {"Heat Kernel (Belkin)", "Cotangent"},
            "Heat Kernel: robust on irregular and noisy meshes. Cotangent, for comparison: only "
            "adjacent vertices; breaks down on irregular meshes."),
        real<&O::accuracy>("accuracy", "Accuracy", 1e-6, 0.1,
                           "Relative error that summing the heat kernel may add, 0.000001 to 0.1. "
                           "Smaller is slower."),
        choice<&O::normal_smoothing>(
            "normal_smoothing", "Normal Smoothing", {"None", "Gaussian"},
            "How the vertex normals that all else is computed from are smoothed; the mesh's own "
            "normals are not changed."),
        real<&O::normal_sigma>(
            "normal_sigma", "Normal Smoothing Sigma", 0, 100,
            "In mean edge lengths. 0 means automatic: none on clean meshes, up to 0.8 on fine ones "
            "and up to 2.5 on noisy ones and terraces of volumes; the log says what was chosen."),
        choice<&O::gradient_estimator>(
            "gradient_estimator", "Gradient Estimator", {"Triangle Fit", "Least Squares"},
            "How the curvature, which gives the gradient of the illumination, is estimated: by a "
            "fit to each triangle or to all vertices in a ball."),
        real<&O::gradient_radius>("gradient_radius", "Gradient Radius", 1, 100,
                                  "For Least Squares: radius of the ball, in mean edge lengths."),
        boolean<&O::correct_borders>(
            "correct_borders", "Correct Borders",
            "Compensate for the missing half of the kernel at holes and borders, which would "
            "otherwise have spurious lines along them."),
        boolean<&O::skip_opposite_sheet>(
            "skip_opposite_sheet", "Skip Opposite Sheet",
            "Vertices count less the more they face another way, so that the two sides of a thin "
            "wall do not affect each other."),
        boolean<&O::weld_duplicates>(
            "weld_duplicates", "Weld Duplicated Vertices",
            "Vertices at one place count as one where they cut the surface open, as in texture "
            "seams; also across cracks of up to .005 % of the diagonal, and at sides that nobody "
            "sees. The mesh is not changed; holes stay open."),
        boolean<&O::curvature_derivatives>(
            "curvature_derivatives", "Curvature Derivatives",
            "Compute smoothed curvatures and their derivatives as well, for programs that read "
            "them. The decoration computes them by itself when a kind of lines needs them."),
    };
    return table;
}

const std::vector<OptionRow<LineStyle>>& line_style_table() {
    using S = LineStyle;
    static const std::vector<OptionRow<S>> table = {
        real<&S::detail>("detail", "Detail", 0, 100,
                         "Fewer or more lines, 0 to 100: moves all thresholds together. 50 leaves "
                         "them as they are."),

        // Which kinds are drawn; what belongs to one alone follows it.
        kind_switch<LineKind::Contour, &S::shows>(),
        boolean<&S::exact_outlines>("exact_outlines", "Exact Outlines",
                                    "Outlines follow edges of a mesh whose triangles are large or "
                                    "meet at steep angles, and are smooth curves on others."),
        kind_switch<LineKind::Laplacian, &S::shows>(),
        boolean<&S::single_strokes>(
            "single_strokes", "Single Strokes",
            "One line along a groove and at the foot of a form, where the surface is concave. Off: "
            "also those on the convex forms beside them, as in the paper."),
        kind_switch<LineKind::Ridge, &S::shows>(),
        real<&S::ridge_angle>(
            "ridge_angle", "Ridge Angle", 5, 180,
            "Least angle in degrees by which the surface turns across a ridge or valley, within 2 "
            "% of the bounding-box diagonal to both sides. Larger leaves out softer ones."),
        kind_switch<LineKind::Crease, &S::shows>(),
        real<&S::crease_angle>(
            "crease_angle", "Crease Angle", 20, 180,
            "Edges of the mesh that turn by at least this angle, in degrees, are always creases. "
            "At 40 or less, softer edges are drawn too where they are no facets of curved faces. "
            "Larger leaves out softer edges; smaller shows facets of coarse round forms."),
        kind_switch<LineKind::Border, &S::shows>(),
        kind_switch<LineKind::Valley, &S::shows>(),
        kind_switch<LineKind::DemarcatingCurve, &S::shows>(),
        real<&S::demarcation>(
            "demarcation", "Least Demarcation", 0, 180,
            "How sharply the surface has to turn from hollow to bulging at a demarcating curve, in "
            "degrees within the scale at which it is looked at. Larger leaves out gentle reliefs."),
        kind_switch<LineKind::SuggestiveContour, &S::shows>(),
        kind_switch<LineKind::SuggestiveHighlight, &S::shows>(),
        real<&S::suggestive_slope>("suggestive_slope", "Least Slope of Suggestive Contours", 0, 1e6,
                                   "Least change of curvature across a suggestive contour (no "
                                   "unit). Larger leaves out lines on gentle forms."),
        kind_switch<LineKind::ApparentRidge, &S::shows>(),
        real<&S::apparent_curvature>(
            "apparent_curvature", "Least Apparent Curvature", 0, 1e6,
            "Least curvature, as it is seen, of an apparent ridge (times the bounding-box "
            "diagonal, no unit). Larger leaves out lines on gentle forms."),
        real<&S::apparent_slope>("apparent_slope", "Least Slope of Apparent Ridges", 0, 1e6,
                                 "How sharp the maximum of the apparent curvature must be (no "
                                 "unit). Larger leaves out faint lines."),
        kind_switch<LineKind::PhoticExtremum, &S::shows>(),
        real<&S::photic_slope>("photic_slope", "Least Slope of Photic Extremum Lines", 0, 1e6,
                               "How sharp the maximum of the change of shading must be (no unit). "
                               "Larger leaves out faint lines."),

        // Thresholds, and how lines on the surface look.
        real<&S::gradient_threshold>(
            "gradient_threshold", "Gradient Threshold t", 0, 1e6,
            "Least change of the shading across a line (gradient times bounding-box diagonal, no "
            "unit). Larger leaves out lines on gentle forms."),
        real<&S::strength_threshold>("strength_threshold", "Strength Threshold tau", 0, 1e6,
                                     "Least strength of a line: its gradient summed along its "
                                     "length (no unit). Larger leaves out short and weak lines."),
        boolean<&S::reject_phantoms>(
            "reject_phantoms", "Reject Phantom Lines",
            "Leave out crossings where the change of shading is smallest instead of largest."),
        boolean<&S::whole_lines>(
            "whole_lines", "Whole Lines",
            "Test means along lines instead of each of their pieces, so that fine texture does not "
            "cut a line into dashes. Redraws take about a fifth longer."),
        real<&S::least_concavity>(
            "least_concavity", "Least Concavity", -1, 1,
            "Least cosine between light and falling shading at a crossing of a whole line. Less "
            "lets fine texture cut fewer lines, but takes longer."),
        real<&S::segment_slope>("segment_slope", "Least Slope of a Segment", 0, 1e6,
                                "How sharply the Laplacian must change sign at each piece of a "
                                "line (no unit). Larger cuts faint pieces off."),
        real<&S::line_slope>(
            "line_slope", "Least Slope of a Line", 0, 1e6,
            "Least mean slope along a whole line (no unit). Larger leaves out faint lines."),
        real<&S::full_slope>("full_slope", "Slope for Full Width", 1e-6, 1e6,
                             "Slope above the least slope of a segment at which a line has its "
                             "full width (no unit). Smaller makes faint lines bolder."),
        real<&S::shortest_line>("shortest_line", "Shortest Line", 0, 10,
                                "Least length of a line, in bounding-box diagonals."),
        real<&S::shortest_contour>("shortest_contour", "Shortest Contour", 0, 10,
                                   "Least length of a contour, in bounding-box diagonals."),
        real<&S::least_facing>("least_facing", "Least Facing", -1, 1,
                               "Least cosine between normal and view direction: 1 faces the eye, 0 "
                               "is a contour, -1 shows lines on the far side as well."),
        real<&S::line_smoothing>(
            "line_smoothing", "Line Smoothing", 0, 10,
            "Smooths the course of lines, which follow the triangles' edges otherwise; standard "
            "deviation in points of a line, a point for each edge that it crosses."),
        real<&S::fading>("fading", "Fading", 0, 1e6,
                         "How gently lines fade in above the thresholds: 0 is a hard cut, 1 means "
                         "full strength at twice the threshold."),
        real<&S::end_length>(
            "end_length", "Fading Ends", 0, 10,
            "Length over which the ends of lines fade, in bounding-box diagonals."),
        real<&S::contour_clearance>("contour_clearance", "Contour Clearance", 0, 10,
                                    "Laplacian lines nearer to an outline than this fade out, "
                                    "since they only double it; in bounding-box diagonals."),
    };
    return table;
}

}  // namespace laplacian_lines
