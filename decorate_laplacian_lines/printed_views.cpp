// SPDX-License-Identifier: GPL-3.0-or-later
// Printed drawings of views: a view that has not changed for a moment is drawn in a thread, one
// after the other; what it draws is dropped if the view has changed meanwhile.
#include "printed_views.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <new>
#include <utility>

#include "laplacian_lines/error.h"
#include "meshlab_host/camera.h"

namespace {

/// Pause after the last change before a drawing is shown, and the least before it is begun.
constexpr int kMillisecondsAtRest = 150, kMillisecondsIdle = 50;
constexpr int kIdleChanges = 2;  // begun after so many times the last interval between changes

/// Up to rounding, since MeshLab computes the projection of a snapshot in another way, and without
/// near and far, which move no line.
bool are_equal(const Eigen::Matrix4d& projection, const Eigen::Matrix4d& other) {
    return meshlab_host::is_orthographic(projection) == meshlab_host::is_orthographic(other) &&
           projection.topRows<2>().isApprox(other.topRows<2>(), 1e-6);
}

/// Without colors, which a picture gets when it is shown.
bool are_equal(const DecorationParameters& chosen, const DecorationParameters& other) {
    const auto& table = decoration_table();
    return std::all_of(table.begin(), table.end(), [&](const auto& row) {
        return row.kind == laplacian_lines::OptionKind::Color || row.get(chosen) == row.get(other);
    });
}

/// Whether pictures of both have the same lines in the same ink.
bool have_same_inks(const DecorationParameters& chosen, const DecorationParameters& other) {
    const std::vector<ColoredInk> inks = inks_of(chosen), others = inks_of(other);
    return std::equal(inks.begin(), inks.end(), others.begin(), others.end(),
                      [](const ColoredInk& a, const ColoredInk& b) {
                          return a.ink.kinds == b.ink.kinds && a.ink.is_hidden == b.ink.is_hidden;
                      });
}

}  // namespace

bool PrintedView::operator==(const PrintedView& other) const {
    return scene == other.scene && are_equal(chosen, other.chosen) &&
           have_same_inks(chosen, other.chosen) && to_eye == other.to_eye &&
           are_equal(projection, other.projection) && window.size == other.window.size &&
           window.pixels_per_mm == other.window.pixels_per_mm;
}

PrintedViews::PrintedViews() {
    rest_.setSingleShot(true);
    QObject::connect(&rest_, &QTimer::timeout, &rest_, [this] { start_next(); });
    // The thread must end before the program tears down what it uses.
    if (QCoreApplication* program = QCoreApplication::instance())
        QObject::connect(program, &QCoreApplication::aboutToQuit, &rest_, [this] {
            is_quitting_ = true;
            stop();
        });
}

PrintedViews::~PrintedViews() {
    stop();
}

Print PrintedViews::request(View view, QWidget* widget, const PrintedView& wanted, bool waits) {
    const auto [place, is_new] = entries_.try_emplace(view);
    Entry& entry = place->second;
    entry.widget = widget;
    if (is_new || !(entry.wanted == wanted)) {
        const qint64 pause = is_new ? 0 : kIdleChanges * entry.since_change.elapsed();
        entry.wanted = wanted;
        entry.since_change.start();
        entry.print = {};
        entry.has_failed = false;
        if (running_ && running_->view == view) running_->is_given_up = true;
        entry.is_at_rest = false;
        rest_.start(int(std::clamp<qint64>(pause, kMillisecondsIdle, kMillisecondsAtRest)));
    }
    if (waits && entry.is_due()) {
        interrupt();
        Running now;
        now.view = view;
        now.what = entry.wanted;
        now.may_wait = true;
        run(now);
        keep(now);
    }
    entry.is_at_rest |= waits || entry.since_change.elapsed() >= kMillisecondsAtRest;
    if (!entry.is_at_rest) return {};
    Print print = entry.print;
    entry.print.missing_reason.clear();
    return print;
}

void PrintedViews::forget(View view) {
    if (running_ && running_->view == view) running_->is_given_up = true;
    entries_.erase(view);
}

std::shared_ptr<PrintedScene> PrintedViews::scene_of(View view) const {
    const auto entry = entries_.find(view);
    return entry == entries_.end() ? nullptr : entry->second.wanted.scene;
}

void PrintedViews::interrupt() {
    stop();
    rest_.start(kMillisecondsAtRest);
}

void PrintedViews::run(Running& running) noexcept {
    QElapsedTimer clock;
    clock.start();
    try {
        PrintedScene& scene = *running.what.scene;
        scene.prepare([&](double, const char*) { return !running.is_stopped; });
        running.print = scene.paint(running.what.window, running.what.chosen, running.may_wait,
                                    [&](double, const char*) { return !running.is_given_up; });
        running.print.milliseconds = 1e-6 * double(clock.nsecsElapsed());
    } catch (const std::bad_alloc&) {
        running.print.missing_reason = "There is not enough memory for the printed drawing.";
    } catch (const laplacian_lines::Error& error) {
        if (error.code() != laplacian_lines::ErrorCode::Cancelled)
            running.print.missing_reason = QString::fromUtf8(error.what());
    } catch (const std::exception& error) {
        running.print.missing_reason = QString::fromUtf8(error.what());
    }
}

/// A view without a picture first: with the kernel at hand it gets one soon.
void PrintedViews::start_next() {
    if (is_quitting_ || running_) return;
    const auto rank = [](const Entry& entry) {
        return !entry.is_due() ? 2 : entry.print.picture ? 1 : 0;
    };
    const auto first = std::min_element(
        entries_.begin(), entries_.end(),
        [&](const auto& a, const auto& b) { return rank(a.second) < rank(b.second); });
    if (first == entries_.end() || !first->second.is_due()) return;
    try {
        auto next = std::make_unique<Running>();
        next->view = first->first;
        next->what = first->second.wanted;
        next->may_wait = first->second.print.picture != nullptr;
        thread_ = std::thread([this, running = next.get()] {
            run(*running);
            running->is_over = true;
            QMetaObject::invokeMethod(
                &rest_, [this] { finish(); }, Qt::QueuedConnection);
        });
        running_ = std::move(next);
    } catch (const std::exception&) {  // no thread: lines stay live
    }
}

void PrintedViews::finish() {
    if (!running_ || !running_->is_over) return;  // it was stopped, and perhaps another began
    thread_.join();
    const std::unique_ptr<Running> done = std::move(running_);
    keep(*done);
    if (!rest_.isActive()) start_next();
}

void PrintedViews::stop() {
    if (!running_) return;
    running_->is_given_up = running_->is_stopped = true;
    thread_.join();
    running_.reset();
}

void PrintedViews::keep(const Running& done) {
    const auto found = entries_.find(done.view);
    if (found == entries_.end() || !(found->second.wanted == done.what)) return;
    Entry& entry = found->second;
    entry.has_failed = !done.print.missing_reason.isEmpty();
    if (done.print.picture) entry.print = done.print;
    if (std::exchange(entry.logged, done.print.missing_reason) != done.print.missing_reason)
        entry.print.missing_reason = done.print.missing_reason;
    if (!entry.widget || (!done.print.picture && !entry.has_failed)) return;
    const qint64 left = kMillisecondsAtRest - entry.since_change.elapsed();
    QTimer::singleShot(int(std::max<qint64>(left, 0)), entry.widget,
                       [widget = entry.widget.data()] { widget->update(); });
}
