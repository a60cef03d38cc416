// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_worker.h"

#include <QCoreApplication>
#include <new>

#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"

using laplacian_lines::Error;
using laplacian_lines::ErrorCode;

namespace {

constexpr int milliseconds_between_looks = 20;

}  // namespace

laplacian_lines::KernelLaplacian computeLevel(const LevelJob& job,
                                              const laplacian_lines::Progress& progress) {
    laplacian_lines::PrecomputeOptions options = job.lines->options;
    options.drawn_kernel_size = job.lines->levels.size(job.level);
    options.curvature_derivatives = false;
    const laplacian_lines::Field field = laplacian_lines::precompute(job.mesh, options, progress);
    return job.lines->extractor->laplacian_of(job.mesh, field);
}

QString reasonWithoutLevel() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return "There is not enough memory for lines of this size.";
    } catch (const Error& error) {
        return error.code() == ErrorCode::Cancelled ? QString() : QString::fromUtf8(error.what());
    } catch (const std::exception& error) {
        return QString::fromUtf8(error.what());
    }
}

LevelWorker::LevelWorker(std::function<void()> finished) : finished_(std::move(finished)) {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { finishIfDone(); });
    // The thread must end before the program tears down what it uses.
    if (QCoreApplication* program = QCoreApplication::instance())
        QObject::connect(program, &QCoreApplication::aboutToQuit, &timer_, [this] { stop(); });
}

LevelWorker::~LevelWorker() {
    stop();
}

void LevelWorker::start(LevelJob job) {
    if (is_stopped_) return;
    running_ = std::make_unique<Running>();
    running_->job = std::move(job);
    try {
        thread_ = std::thread([running = running_.get()] { run(*running); });
    } catch (...) {
        running_.reset();
        throw;
    }
    timer_.start(milliseconds_between_looks);
}

void LevelWorker::redrawAtEnd(QWidget* widget) {
    for (const QPointer<QWidget>& known : waiting_)
        if (known == widget) return;
    if (widget) waiting_.emplace_back(widget);
}

void LevelWorker::stop() {
    is_stopped_ = true;
    timer_.stop();
    if (!running_) return;
    running_->is_given_up = true;
    thread_.join();
    running_.reset();
}

void LevelWorker::run(Running& running) noexcept {
    try {
        const auto is_wanted = [&](double, const char*) {
            return !running.is_given_up && running.job.lines.use_count() > 1;
        };
        running.result = computeLevel(running.job, is_wanted);
    } catch (...) {
        running.failure = reasonWithoutLevel();
    }
    running.is_done = true;
}

void LevelWorker::finishIfDone() {
    if (running_ && running_->is_done) finish();
}

void LevelWorker::finish() {
    thread_.join();
    timer_.stop();
    const std::unique_ptr<Running> done = std::move(running_);
    PreparedLines& lines = *done->job.lines;
    if (done->result)
        addLevel(lines, done->job.level, std::move(*done->result));
    else if (!done->failure.isEmpty())
        lines.failed_levels[done->job.level] = done->failure;
    finished_();
    for (const QPointer<QWidget>& widget : waiting_)
        if (widget) widget->update();
    waiting_.clear();
}
