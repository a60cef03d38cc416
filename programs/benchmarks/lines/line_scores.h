// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_set.h"
#include "rounded_walls.h"

namespace benchmarks {

/// Points along curves, each standing for a length.
struct CurvePoints {
    std::vector<Eigen::Vector3d> points;
    std::vector<double> lengths;

    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double step);
};

/// Segments of some kinds with at least some opacity.
CurvePoints drawn_points(const laplacian_lines::LineSet& lines, laplacian_lines::LineKindSet kinds,
                         double least_opacity, double step);
CurvePoints arris_points(const std::vector<test_meshes::ArrisPiece>& arrises, double step);

struct Share {
    double part = 0, all = 0;

    double value() const { return all > 0 ? part / all : 0; }
    Share& operator+=(const Share& other);
};

/// Of the length of `curves`, what is within `reach` of `others`.
Share share_near(const CurvePoints& curves, const CurvePoints& others, double reach);

struct Score {
    Share recall;     ///< of what there should be, what is drawn
    Share precision;  ///< of what is drawn, what there should be

    /// Harmonic mean; 0 if nothing that is drawn should be.
    double f1() const;
    /// Nothing to draw and nothing drawn.
    bool is_empty() const { return recall.all == 0 && precision.all == 0; }
    Score& operator+=(const Score& other);
};

/// A drawing against the right one, both ways at the same distance.
Score compare(const CurvePoints& drawing, const CurvePoints& right, double reach);

/// Arrises of a form by what a drawing should do with them.
struct Truth {
    std::vector<test_meshes::ArrisPiece> sharp;  ///< have to be drawn
    std::vector<test_meshes::ArrisPiece> blunt;  ///< may be drawn

    /// Leaves out all else. Degrees.
    Truth(const std::vector<test_meshes::ArrisPiece>& arrises, double sharp_angle,
          double blunt_angle);
    Truth convex() const { return of_side(true); }
    Truth concave() const { return of_side(false); }
    /// What an orthographic view has to draw, and all that it may.
    Truth facing(const Eigen::Vector3d& towards_viewer) const;

private:
    Truth() = default;
    Truth of_side(bool convex) const;
};

/// When a line counts as an arris, mesh units.
struct Matching {
    double reach;
    double least_opacity;  ///< less is not drawn

    double step() const { return reach / 8; }  ///< between the points of curves
};

/// Recall of all `kinds`, but precision only of `edges`: other kinds draw more than arrises.
Score score(const laplacian_lines::LineSet& lines, const Truth& truth,
            laplacian_lines::LineKindSet kinds, laplacian_lines::LineKindSet edges,
            const Matching& matching);

}  // namespace benchmarks
