// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "prepared_lines.h"

struct LevelJob {
    PreparedLinesPointer lines;  ///< with an extractor; not changed
    laplacian_lines::TriangleMesh mesh;
    int level = 0;
};

/// As the extractor's field, but with the level's kernel. @throws laplacian_lines::Error,
/// std::bad_alloc
laplacian_lines::KernelLaplacian computeLevel(const LevelJob& job,
                                              const laplacian_lines::Progress& progress = {});

/// From the exception being handled; empty if the level was given up.
QString reasonWithoutLevel();

/// Computes one level at a time on its own thread. Gives up a job whose lines nobody else has any
/// more, because the mesh has changed or is gone. GUI thread only.
class LevelWorker {
public:
    /// `finished` runs on the GUI thread when lines got a level or a failed one.
    explicit LevelWorker(std::function<void()> finished);
    ~LevelWorker();  ///< gives up, and waits for the thread
    LevelWorker(const LevelWorker&) = delete;
    LevelWorker& operator=(const LevelWorker&) = delete;

    bool isBusy() const { return running_ != nullptr; }
    /// Not while busy. @throws std::system_error if there is no thread
    void start(LevelJob job);
    /// Redraws the widget, which may be null, when the work ends.
    void redrawAtEnd(QWidget* widget);
    void stop();

private:
    struct Running {
        LevelJob job;
        std::atomic<bool> is_given_up{false}, is_done{false};
        std::optional<laplacian_lines::KernelLaplacian> result;
        QString failure;  ///< empty if it was given up
    };

    static void run(Running& running) noexcept;
    void finishIfDone();
    void finish();

    const std::function<void()> finished_;
    std::unique_ptr<Running> running_;
    std::thread thread_;
    std::vector<QPointer<QWidget>> waiting_;
    bool is_stopped_ = false;
    QTimer timer_;  ///< looks whether the thread is done
};
