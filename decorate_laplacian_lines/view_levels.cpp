// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_levels.h"

#include <QCoreApplication>
#include <atomic>
#include <new>
#include <optional>

#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"
#include "meshlab_host/geometry_stamp.h"
#include "meshlab_host/mesh_conversion.h"

using laplacian_lines::DrawnKernel;
using laplacian_lines::Error;
using laplacian_lines::ErrorCode;
using laplacian_lines::LevelShare;

namespace {

constexpr int milliseconds_between_looks = 20;

struct LevelJob {
    PreparedLinesPointer lines;  ///< with an extractor; not changed
    laplacian_lines::TriangleMesh mesh;
    int level = 0;
};

/// As the extractor's field, but with the level's kernel. @throws laplacian_lines::Error,
/// std::bad_alloc
laplacian_lines::KernelLaplacian computeLevel(const LevelJob& job,
                                              const laplacian_lines::Progress& progress = {}) {
    laplacian_lines::PrecomputeOptions options = job.lines->options;
    options.drawn_kernel_size = job.lines->levels.size(job.level);
    options.curvature_derivatives = false;
    const laplacian_lines::Field field = laplacian_lines::precompute(job.mesh, options, progress);
    return job.lines->extractor->laplacian_of(job.mesh, field);
}

/// From the exception being handled; empty if the level was given up.
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

bool isMissing(const PreparedLines& lines, int level) {
    return !lines.kept_levels.has(level) && !lines.failed_levels.count(level);
}

/// The first missing level of a drawing, or else of those it may need next.
std::optional<int> levelToCompute(const PreparedLines& lines,
                                  const std::vector<LevelShare>& shares) {
    for (const LevelShare& share : shares)
        if (isMissing(lines, share.level)) return share.level;
    const int drawn = shares.front().level;
    for (const int next : {drawn - 1, drawn + 1})
        if (next >= 0 && next < lines.levels.count() && isMissing(lines, next) &&
            hasRoomForLevel(lines))
            return next;
    return std::nullopt;
}

void computeNow(const PreparedLinesPointer& lines, const CMeshO& mesh, int level) {
    try {
        addLevel(*lines, level, computeLevel({lines, meshlab_host::toTriangleMesh(mesh), level}));
        lines->kept_levels.use(level);  // nor dropped for the next one of this drawing
    } catch (...) {
        lines->failed_levels[level] = reasonWithoutLevel();
    }
}

std::vector<DrawnKernel> kernelsThatAreThere(PreparedLines& lines,
                                             const std::vector<LevelShare>& shares) {
    const int nearest = lines.kept_levels.nearest(shares.front().level);
    if (nearest < 0) return {DrawnKernel()};
    if (nearest != shares.front().level)
        return {DrawnKernel{lines.levels.size(nearest), lines.kept_levels.find(nearest), 1}};
    std::vector<DrawnKernel> kernels;
    for (const LevelShare& share : shares)
        if (const auto* laplacian = lines.kept_levels.use(share.level))
            kernels.push_back({lines.levels.size(share.level), laplacian, share.share});
    return kernels;
}

}  // namespace

struct ViewLevels::Running {
    LevelJob job;
    std::atomic<bool> is_given_up{false}, is_done{false};
    std::optional<laplacian_lines::KernelLaplacian> result;
    QString failure;  ///< empty if it was given up

    void run() noexcept {
        try {
            const auto is_wanted = [this](double, const char*) {
                return !is_given_up && job.lines.use_count() > 1;
            };
            result = computeLevel(job, is_wanted);
        } catch (...) {
            failure = reasonWithoutLevel();
        }
        is_done = true;
    }
};

ViewLevels::ViewLevels(std::function<void()> grown) : grown_(std::move(grown)) {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { finishIfDone(); });
    // The thread must end before the program tears down what it uses.
    if (QCoreApplication* program = QCoreApplication::instance())
        QObject::connect(program, &QCoreApplication::aboutToQuit, &timer_, [this] { stop(); });
}

ViewLevels::~ViewLevels() {
    stop();
}

std::vector<DrawnKernel> ViewLevels::demand(const PreparedLinesPointer& lines, const CMeshO& mesh,
                                            double wanted, QWidget* widget, bool waits) {
    if (!(wanted > 0)) return {DrawnKernel()};
    const std::vector<LevelShare> shares = lines->levels.at(wanted);
    if (!waits)
        computeInBackground(lines, mesh, shares, widget);
    else
        for (const LevelShare& share : shares)
            if (isMissing(*lines, share.level)) computeNow(lines, mesh, share.level);
    return kernelsThatAreThere(*lines, shares);
}

void ViewLevels::computeInBackground(const PreparedLinesPointer& lines, const CMeshO& mesh,
                                     const std::vector<LevelShare>& shares, QWidget* widget) {
    const std::optional<int> level = levelToCompute(*lines, shares);
    if (!level) return;
    redrawAtEnd(widget);
    // While the camera moves, redraws check for changes of the mesh only now and then.
    if (running_ || is_stopped_ || meshlab_host::geometryStamp(mesh) != lines->key.stamp) return;
    try {
        start(lines, mesh, *level);
    } catch (...) {
        running_.reset();
        lines->failed_levels[*level] = reasonWithoutLevel();
    }
}

void ViewLevels::start(const PreparedLinesPointer& lines, const CMeshO& mesh, int level) {
    running_ = std::make_unique<Running>();
    running_->job = {lines, meshlab_host::toTriangleMesh(mesh), level};
    thread_ = std::thread([running = running_.get()] { running->run(); });
    timer_.start(milliseconds_between_looks);
}

void ViewLevels::redrawAtEnd(QWidget* widget) {
    for (const QPointer<QWidget>& known : waiting_)
        if (known == widget) return;
    if (widget) waiting_.emplace_back(widget);
}

void ViewLevels::stop() {
    is_stopped_ = true;
    timer_.stop();
    if (!running_) return;
    running_->is_given_up = true;
    thread_.join();
    running_.reset();
}

void ViewLevels::finishIfDone() {
    if (!running_ || !running_->is_done) return;
    thread_.join();
    timer_.stop();
    const std::unique_ptr<Running> done = std::move(running_);
    PreparedLines& lines = *done->job.lines;
    if (done->result)
        addLevel(lines, done->job.level, std::move(*done->result));
    else if (!done->failure.isEmpty())
        lines.failed_levels[done->job.level] = done->failure;
    grown_();
    for (const QPointer<QWidget>& widget : waiting_)
        if (widget) widget->update();
    waiting_.clear();
}
