// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "laplacian_lines/kernel_levels.h"
#include "level_worker.h"

/// Finds the levels that drawings ask for while missing ones are computed in the background. GUI
/// thread only.
class ViewLevels {
public:
    /// `grown` is called when lines have a new level.
    explicit ViewLevels(std::function<void()> grown) : worker_(std::move(grown)) {}

    /// What to draw of a mesh where the √h `wanted`, mesh units, suits the picture: the nearest
    /// levels there are. `widget` or null shows it, and is redrawn when better ones are there; if
    /// it `waits`, these are computed at once. None unless `wanted` is above 0. The mesh is copied.
    std::vector<laplacian_lines::DrawnKernel> demand(const PreparedLinesPointer& lines,
                                                     const CMeshO& mesh, double wanted,
                                                     QWidget* widget, bool waits);

private:
    void computeInBackground(const PreparedLinesPointer& lines, const CMeshO& mesh,
                             const std::vector<laplacian_lines::LevelShare>& shares,
                             QWidget* widget);

    LevelWorker worker_;
};
