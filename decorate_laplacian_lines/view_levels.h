// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "laplacian_lines/kernel_levels.h"
#include "prepared_lines.h"

/// Finds the levels that drawings ask for, while missing ones are computed one at a time on a
/// thread. Gives up a level whose lines nobody else has any more, because the mesh has changed or
/// is gone. GUI thread only.
class ViewLevels {
public:
    /// `grown` is called when lines have a new level or a failed one.
    explicit ViewLevels(std::function<void()> grown);
    ~ViewLevels();  ///< gives up, and waits for the thread
    ViewLevels(const ViewLevels&) = delete;
    ViewLevels& operator=(const ViewLevels&) = delete;

    /// What to draw of a mesh where the √h `wanted`, mesh units, suits the picture: the nearest
    /// levels there are. `widget` or null shows it, and is redrawn when better ones are there; if
    /// it `waits`, these are computed at once. None unless `wanted` is above 0. The mesh is copied.
    std::vector<laplacian_lines::DrawnKernel> demand(const PreparedLinesPointer& lines,
                                                     const CMeshO& mesh, double wanted,
                                                     QWidget* widget, bool waits);

private:
    struct Running;

    void computeInBackground(const PreparedLinesPointer& lines, const CMeshO& mesh,
                             const std::vector<laplacian_lines::LevelShare>& shares,
                             QWidget* widget);
    void start(const PreparedLinesPointer& lines, const CMeshO& mesh, int level);
    void redrawAtEnd(QWidget* widget);
    void finishIfDone();
    void stop();

    const std::function<void()> grown_;
    std::unique_ptr<Running> running_;
    std::thread thread_;
    std::vector<QPointer<QWidget>> waiting_;
    bool is_stopped_ = false;
    QTimer timer_;  ///< looks whether the thread is done
};
