// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <thread>
#include <utility>
#include <vector>

#include "laplacian_lines/error.h"
#include "laplacian_lines/progress.h"

namespace line_drawing {

/// Progress of a part of the work, from `begin` to `end` of the whole.
inline laplacian_lines::Progress part(const laplacian_lines::Progress& progress, double begin,
                                      double end) {
    if (!progress) return {};
    return [=](double done, const char* stage) {
        return progress((1 - done) * begin + done * end, stage);
    };
}

/// @throws laplacian_lines::Error(Cancelled)
inline void report(const laplacian_lines::Progress& progress, double done, const char* stage) {
    if (progress && !progress(done, stage))
        laplacian_lines::refuse("Cancelled; the mesh was not changed.",
                                laplacian_lines::ErrorCode::Cancelled);
}

/// Progress of equal tasks on several threads, reported only by the thread that made this, since
/// windows may show it.
class SharedProgress {
public:
    SharedProgress(laplacian_lines::Progress all, std::size_t tasks)
        : all_(std::move(all)), done_(tasks) {}

    laplacian_lines::Progress of(std::size_t task) {
        if (!all_) return {};
        return [this, task](double done, const char* stage) { return tell(task, done, stage); };
    }

private:
    bool tell(std::size_t task, double done, const char* stage) {
        done_[task] = done;
        if (std::this_thread::get_id() == teller_ && !is_stopped_) {
            double sum = 0;
            for (const std::atomic<double>& of_task : done_)
                sum += of_task;
            is_stopped_ = !all_(sum / double(done_.size()), stage);
        }
        return !is_stopped_;
    }

    const laplacian_lines::Progress all_;
    const std::thread::id teller_ = std::this_thread::get_id();
    std::vector<std::atomic<double>> done_;  // by task
    std::atomic<bool> is_stopped_{false};
};

}  // namespace line_drawing
