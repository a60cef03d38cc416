// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_kind.h"

namespace laplacian_lines {

/// Which zero crossings become lines. Thresholds are dimensionless, so one style serves models of
/// any size from any view. D is the bounding-box diagonal. The illumination is I = s n·l with
/// s = 1/|e − c|, c the centre of the box, for perspective views and unit l for orthographic ones.
/// Names, limits and help texts: option_table.h.
struct LineStyle {
    /// 0..100, moves the thresholds of all lines but contours together, of creases and borders the
    /// least length alone: 50 leaves them as they are, 0 keeps hardly a line, 100 nearly all. The
    /// number of lines grows about evenly with it. By which powers: src/rules/thresholds.cpp.
    double detail = 50;
    /// t, the least ‖∇I‖·D at a crossing (the paper's threshold on the gradient).
    double gradient_threshold = 0.8;
    /// τ, the least strength of a line, Σ (‖∇I‖_i + ‖∇I‖_i+1)/2 · length of the segment (Eq. 4).
    double strength_threshold = 0.01;
    /// Drop crossings where the gradient of the illumination has a minimum instead of a maximum:
    /// ∇(ΔI)·∇I > 0. The paper has no such test.
    bool reject_phantoms = true;
    /// Keep only lines where the surface is concave towards the light, l·∇I = l·S l < 0: one line
    /// in a groove, one at the foot of each flank of a ridge. The paper also draws the parallel
    /// lines on the convex forms beside them.
    bool single_strokes = true;
    /// The slope of a crossing is ‖∇(ΔI)‖ · h_e^1.5, h_e = h + σ²/2 (kernel and normal smoothing).
    double segment_slope = 0.004;  ///< least slope of a segment
    double line_slope = 0.012;     ///< least mean slope of a line
    /// Trace Laplacian lines whole and test means along them: all thresholds on segments, Single
    /// Strokes and phantoms. Otherwise each crossing is tested alone, as in the paper, which leaves
    /// dashes where detail finer than the kernel changes S. See src/rules/line_parts.h.
    bool whole_lines = false;
    /// With single_strokes: least cosine between −∇I and the tangential part of l at a crossing of
    /// a whole line. −1: texture finer than the kernel cuts nothing, at a cost in time.
    double least_concavity = -0.5;
    double full_slope = 0.25;     ///< slope above segment_slope at which a line has its full width
    double shortest_line = 0.01;  ///< least length of a line, in D
    double least_facing = -0.15;  ///< least n·l/|l| at a crossing
    /// Standard deviation, in points of a line, of its smoothing: lines follow the triangles'
    /// edges, which shows on coarse and noisy meshes.
    double line_smoothing = 1.2;
    /// Lines fade in above the thresholds of slope, length and strength, from nothing at the
    /// threshold to full opacity at (1 + fading) times it. 0: no fading.
    double fading = 1;
    double end_length = 0.01;  ///< length over which open ends of lines fade, in D
    /// Lines but creases and borders nearer to a contour than this, in D in the picture, only
    /// double it: they fade out, to nothing at half the distance, ridges and valleys at four times
    /// these. Only if contours are drawn; Laplacian and photic lines if the light is at the eye.
    double contour_clearance = 0.001;
    LineKindSet shows = LineKindSet::defaults();  ///< which kinds are drawn
    /// Draw contours along mesh edges, between triangles that face the eye and those that do not,
    /// on meshes of triangles so large or so steep that zeros of n·v would miss the horizon.
    bool exact_outlines = true;
    double shortest_contour = 0.005;  ///< least length of a contour, in D
    /// Least angle, degrees, by which the surface turns across a ridge or valley within 2 % of D to
    /// both sides, or four times that within 1 %; turning as fast beyond, or on one side only,
    /// counts against it. Weaker parts go on down to half.
    double ridge_angle = 10;
    /// Least angle between the normals of two triangles, degrees, whose edge is a crease whatever
    /// surrounds it. Smaller angles, from 3 degrees on, count as 40 where the faces around do not
    /// explain them.
    double crease_angle = 40;
    /// Least strength of a demarcating curve, degrees: C(g,g,g), the change of curvature across it,
    /// times h_e.
    double demarcation = 4;
    /// Least (x h_e)^1.5 at a suggestive contour, x the derivative of the radial curvature towards
    /// the eye over n·v/|v|; twice that at a highlight.
    double suggestive_slope = 0.005;
    /// Least q1·D of an apparent ridge, q1 the largest curvature as it is seen on the screen.
    double apparent_curvature = 15;
    /// Least −d²q1/dr² h_e^1.5 of an apparent ridge, r across it.
    double apparent_slope = 0.02;
    /// Least −d²‖∇I‖/dg² h_e^1.5 of a photic extremum line, g along ∇I.
    double photic_slope = 0.004;
};

/// @throws Error(InvalidOption) naming the first value that is out of range.
void validate(const LineStyle& style);

}  // namespace laplacian_lines
