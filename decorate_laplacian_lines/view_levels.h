// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "laplacian_lines/kernel_levels.h"
#include "level_worker.h"

/// Finds the levels that drawings ask for: those that are there, while others are computed in the
/// background. GUI thread only.
class ViewLevels {
public:
    /// `grown` is called when lines have got a level.
    explicit ViewLevels(std::function<void()> grown) : worker_(std::move(grown)) {}

    /// What is to be drawn of a mesh with these lines where the √h `wanted`, mesh units, suits the
    /// picture: the nearest levels that there are. `widget` shows it, or null, and is redrawn when
    /// there are better ones. If `waits`, they are computed at once instead. A `wanted` that is not
    /// above 0 asks for none of them. The mesh is copied, not changed.
    std::vector<laplacian_lines::DrawnKernel> demand(const PreparedLinesPointer& lines,
                                                     const CMeshO& mesh, double wanted,
                                                     QWidget* widget, bool waits);

private:
    void computeInBackground(const PreparedLinesPointer& lines, const CMeshO& mesh,
                             const std::vector<laplacian_lines::LevelShare>& shares,
                             QWidget* widget);

    LevelWorker worker_;
};
