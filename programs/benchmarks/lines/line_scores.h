// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_set.h"
#include "rounded_walls.h"

namespace benchmarks {

/// Curves as points along them, each of which stands for a length.
struct CurvePoints {
    std::vector<Eigen::Vector3d> points;
    std::vector<double> lengths;

    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double step);
};

/// What is drawn of some kinds: segments of at least some opacity.
CurvePoints drawn_points(const laplacian_lines::LineSet& lines, laplacian_lines::LineKindSet kinds,
                         double least_opacity, double step);
CurvePoints arris_points(const std::vector<test_meshes::ArrisPiece>& arrises, double step);

/// A part of a length.
struct Share {
    double part = 0, all = 0;

    double value() const { return all > 0 ? part / all : 0; }
    Share& operator+=(const Share& other);
};

/// Of the length of `curves`, what has one of `others` within `reach`.
Share share_near(const CurvePoints& curves, const CurvePoints& others, double reach);

struct Score {
    Share recall;     ///< of what there should be, what is drawn
    Share precision;  ///< of what is drawn, what there should be

    /// The harmonic mean of both; 0 if nothing that is drawn should be.
    double f1() const;
    /// Whether there is anything to draw, or anything drawn.
    bool is_empty() const { return recall.all == 0 && precision.all == 0; }
    Score& operator+=(const Score& other);
};

/// Of a drawing against another one that is right, both ways with the same distance.
Score compare(const CurvePoints& drawing, const CurvePoints& right, double reach);

/// The arrises of a form by what they mean to a drawing.
struct Truth {
    std::vector<test_meshes::ArrisPiece> sharp;  ///< have to be drawn
    std::vector<test_meshes::ArrisPiece> blunt;  ///< may be drawn

    /// All else is left out. Angles in degrees.
    Truth(const std::vector<test_meshes::ArrisPiece>& arrises, double sharp_angle,
          double blunt_angle);
    Truth convex() const { return of_side(true); }
    Truth concave() const { return of_side(false); }
    /// What has to be drawn from an orthographic view, and all that may be.
    Truth facing(const Eigen::Vector3d& towards_viewer) const;

private:
    Truth() = default;
    Truth of_side(bool convex) const;
};

/// What decides that a line and an arris are the same. Lengths in mesh units.
struct Matching {
    double reach;
    double least_opacity;  ///< less is not drawn

    double step() const { return reach / 8; }  ///< between the points of curves
};

/// Recall by lines of all `kinds`, precision of those of them that are `edges`: other kinds have
/// more to draw than arrises.
Score score(const laplacian_lines::LineSet& lines, const Truth& truth,
            laplacian_lines::LineKindSet kinds, laplacian_lines::LineKindSet edges,
            const Matching& matching);

}  // namespace benchmarks
