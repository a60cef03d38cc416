// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <thread>
#include <vector>

#include "prepared_lines.h"
#include "printed_scene.h"

/// What decides the picture of a view.
struct PrintedView {
    PreparedLinesPointer lines;  ///< with a scene
    line_drawing::WindowView window;
    line_drawing::SheetOptions options;
    std::vector<double> chosen;  ///< the parameters that made the options

    bool operator==(const PrintedView& other) const;
};

struct Print {
    line_renderer::InkPicturePointer picture;  ///< null: none
    double milliseconds = 0;                   ///< that it took
};

/// Views as they would be printed: each is drawn by a thread once it has not changed for a while.
/// A change gives up its drawing at once. GUI thread only.
class PrintedViews {
public:
    using View = const void*;  ///< a name, never followed

    /// `say` is told on the GUI thread what a drawing lacked.
    explicit PrintedViews(std::function<void(const QString&)> say);
    ~PrintedViews();  ///< gives up, and waits for the thread
    PrintedViews(const PrintedViews&) = delete;
    PrintedViews& operator=(const PrintedViews&) = delete;

    /// The print, if it is ready. If not, the widget, which may be null, is redrawn when it is, or
    /// with `waits` it is drawn now. None if there is none yet, or cannot be.
    Print demand(View view, QWidget* widget, const PrintedView& wanted, bool waits);
    void forget(View view);

private:
    struct Entry {
        PrintedView wanted;
        QPointer<QWidget> widget;
        Print print;
        bool has_failed = false;

        bool isDue() const { return !print.picture && !has_failed; }
    };
    struct Running {
        View view;
        PrintedView what;
        std::atomic<bool> is_given_up{false};
        Print print;
        QString failure;  ///< empty if it was given up
    };

    static void run(Running& running) noexcept;
    void startNext();
    void finish();
    void stop();
    void keep(const Running& done);

    const std::function<void(const QString&)> say_;
    std::map<View, Entry> entries_;
    std::unique_ptr<Running> running_;
    std::thread thread_;
    bool is_stopped_ = false;
    QTimer rest_;
};
