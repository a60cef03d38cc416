// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QPointer>

#include "laplacian_lines/progress.h"

class QProgressBar;
class QStatusBar;
class QWidget;

namespace meshlab_host {

/// The progress bar and the message at the foot of MeshLab's window, for work outside of filters,
/// to which MeshLab hands no callback. MeshLab's own one would let events happen, a redraw or a
/// deletion of the very mesh among them, so the foot is painted here with the panels that wait for
/// it, and views go on waiting: nobody can press anything meanwhile, and there is nothing to cancel
/// by. Not to be used while a view is painted. Does nothing in programs without such a window. GUI
/// thread only.
class WindowProgress {
public:
    WindowProgress();
    ~WindowProgress();  ///< takes back what was shown
    WindowProgress(const WindowProgress&) = delete;
    WindowProgress& operator=(const WindowProgress&) = delete;

    /// Reports of a step from `begin` to `end` (0..1) of all that is done, each after the words
    /// "Laplacian Lines". They must not outlive this object, and show after a tenth of a second.
    laplacian_lines::Progress step(double begin, double end);

private:
    void show(double done, const char* stage);
    void letViewsWait();

    QPointer<QStatusBar> status_;
    QPointer<QProgressBar> bar_;
    QPointer<QWidget> views_;  ///< that wait
    QElapsedTimer since_shown_;
    bool is_shown_ = false;
};

}  // namespace meshlab_host
