// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace benchmarks {

struct DrawingOptions {
    double tolerance = 0.25;  ///< pixels
    int eyes = 6;             ///< of an orbit
    double zoom = 1;
    bool is_dashed = false;  ///< hidden lines are drawn too, dashed
    std::string pictures;    ///< folder for those of the first eye; empty: none
};

/// Means over the eyes; milliseconds are the best of seven rounds, in which both take turns.
struct DrawingFigures {
    double segments = 0;
    double writing = 0;  ///< ms to write the stream, of one processor
    double drawing = 0;  ///< ms of OpenGL
};

struct DrawingComparison {
    DrawingFigures all, simplified;
    double length = 0;      ///< of the lines in the view, pixels
    double extraction = 0;  ///< ms
    int greatest_difference = 0;
    double mean_difference = 0;     ///< of the pixels that differ
    std::array<double, 3> above{};  ///< share of pixels that differ by more than 32, 64, 128
};

/// Draws the lines of a mesh with all their points and with those that can be seen.
/// @throws std::runtime_error
DrawingComparison compareDrawings(const laplacian_lines::TriangleMesh& mesh,
                                  const laplacian_lines::Field& field,
                                  const DrawingOptions& options);

}  // namespace benchmarks
