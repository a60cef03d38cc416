// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QPointer>

#include "laplacian_lines/progress.h"

class QProgressBar;
class QStatusBar;
class QWidget;

namespace meshlab_host {

/// The progress bar and message at the foot of MeshLab's window, for work outside filters, which
/// has no callback. MeshLab's own would process events, such as deleting the mesh, so this only
/// paints the foot and waiting panels; views wait, nothing can be pressed or cancelled. Not while a
/// view is painted. Does nothing without such a window. GUI thread only.
class WindowProgress {
public:
    WindowProgress();
    ~WindowProgress();  ///< takes back what was shown
    WindowProgress(const WindowProgress&) = delete;
    WindowProgress& operator=(const WindowProgress&) = delete;

    /// A step from `begin` to `end` (0..1), reported after "Laplacian Lines". Must not outlive
    /// this; shows after a tenth of a second.
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
