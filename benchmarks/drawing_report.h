// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "drawing_measures.h"
#include "speed_report.h"

namespace benchmarks {

/// From this mean share on, the outline of a mesh counts as drawn.
constexpr double kComplete = 0.995;

struct MeasuredDrawing {
    std::string name, group;  ///< group: where the mesh is from
    bool is_sharp = false;    ///< its edges are part of the form
    MeshMeasures measures;
};

/// The least complete outline first; meshes without any outline last; equal ones by name.
void sort_by_worst(std::vector<MeasuredDrawing>& drawings);

/// A line for each mesh, in their order.
std::string drawing_table(const std::vector<MeasuredDrawing>& drawings);
/// Shares over all meshes, over each group, over sharp ones and the others; and the first ten.
std::string drawing_summary(const std::vector<MeasuredDrawing>& drawings);
/// For json_report().
std::vector<MeshFigures> drawing_figures(const std::vector<MeasuredDrawing>& drawings);

/// Writes a PPM file: surface pale green, missed outline red, lines black.
/// @throws std::runtime_error
void write_picture(const DrawnView& view, const std::string& file);

}  // namespace benchmarks
