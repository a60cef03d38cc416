// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <atomic>
#include <map>
#include <memory>
#include <thread>

#include "printed_scene.h"

/// All that the picture of a view depends on.
struct PrintedView {
    std::shared_ptr<PrintedScene> scene;
    Eigen::Matrix4d to_eye, projection;  ///< the first from the scene's coordinates
    /// window_of() of both, with pixels_per_mm that make the pen of inner lines Line Width.
    line_drawing::WindowView window;
    DecorationParameters chosen;

    /// Whether pictures are the same but for colors, with projections up to rounding.
    bool operator==(const PrintedView& other) const;
};

/// Views as they would be printed: each is drawn in a thread once it has not changed for a while,
/// at first with the nearest cached kernel. A change cancels its drawing at once, but not work that
/// other views need as well. GUI thread only.
class PrintedViews {
public:
    using View = const void*;  ///< a key, never dereferenced

    PrintedViews();
    ~PrintedViews();  ///< cancels, and waits for the thread
    PrintedViews(const PrintedViews&) = delete;
    PrintedViews& operator=(const PrintedViews&) = delete;

    /// The print, if it is ready. Else starts it and returns an empty one; the widget, which may be
    /// null, is redrawn when it is ready or has failed. With `waits` it is drawn now.
    Print request(View view, QWidget* widget, const PrintedView& wanted, bool waits);
    void forget(View view);
    /// The scene of the view's print, if any.
    std::shared_ptr<PrintedScene> scene_of(View view) const;
    /// Stops the thread, so that scenes may be changed; it restarts when the view is at rest.
    void interrupt();

private:
    struct Entry {
        PrintedView wanted;
        QElapsedTimer since_change;
        QPointer<QWidget> widget;
        Print print;
        bool has_failed = false, is_at_rest = false;
        QString logged;  ///< why the last one failed

        bool is_due() const { return !print.is_final && !has_failed; }
    };
    struct Running {
        View view;
        PrintedView what;
        bool may_wait = false;                 ///< for a field
        std::atomic<bool> is_given_up{false};  ///< the view changed: cancels its picture
        std::atomic<bool> is_stopped{false};   ///< cancels what other views need as well
        std::atomic<bool> is_over{false};      ///< the thread is about to end
        Print print;                           ///< without a reason if it was cancelled
    };

    static void run(Running& running) noexcept;
    void start_next();
    void finish();
    void stop();
    void keep(const Running& done);

    std::map<View, Entry> entries_;
    std::unique_ptr<Running> running_;
    std::thread thread_;
    bool is_quitting_ = false;  ///< nothing is started any more
    QTimer rest_;               ///< runs out when views are at rest
};
