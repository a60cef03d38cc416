// SPDX-License-Identifier: GPL-3.0-or-later
#include "printed_views.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <new>
#include <system_error>

#include "laplacian_lines/error.h"

namespace {

constexpr int milliseconds_at_rest = 150;

}  // namespace

bool PrintedView::operator==(const PrintedView& other) const {
    return lines == other.lines && chosen == other.chosen &&
           window.to_clip == other.window.to_clip && window.size == other.window.size &&
           window.pixels_per_mm == other.window.pixels_per_mm;
}

PrintedViews::PrintedViews(std::function<void(const QString&)> say) : say_(std::move(say)) {
    rest_.setSingleShot(true);
    QObject::connect(&rest_, &QTimer::timeout, &rest_, [this] { startNext(); });
    // The thread must end before the program tears down what it uses.
    if (QCoreApplication* program = QCoreApplication::instance())
        QObject::connect(program, &QCoreApplication::aboutToQuit, &rest_, [this] {
            is_stopped_ = true;
            stop();
        });
}

PrintedViews::~PrintedViews() {
    stop();
}

Print PrintedViews::demand(View view, QWidget* widget, const PrintedView& wanted, bool waits) {
    Entry& entry = entries_[view];
    entry.widget = widget;
    if (!(entry.wanted == wanted)) {
        entry.wanted = wanted;
        entry.print = {};
        entry.has_failed = false;
        if (running_ && running_->view == view) running_->is_given_up = true;
        rest_.start(milliseconds_at_rest);
    }
    if (waits && entry.isDue()) {
        stop();
        Running now;
        now.view = view;
        now.what = wanted;
        run(now);
        keep(now);
    }
    return entry.print;
}

void PrintedViews::forget(View view) {
    if (running_ && running_->view == view) running_->is_given_up = true;
    entries_.erase(view);
}

void PrintedViews::run(Running& running) noexcept {
    QElapsedTimer clock;
    clock.start();
    try {
        running.print.picture = running.what.lines->scene->paint(
            running.what.window, running.what.options,
            [&](double, const char*) { return !running.is_given_up; });
        running.print.milliseconds = 1e-6 * double(clock.nsecsElapsed());
    } catch (const std::bad_alloc&) {
        running.failure = "There is not enough memory for the printed drawing.";
    } catch (const laplacian_lines::Error& error) {
        if (error.code() != laplacian_lines::ErrorCode::Cancelled)
            running.failure = QString::fromUtf8(error.what());
    } catch (const std::exception& error) {
        running.failure = QString::fromUtf8(error.what());
    }
}

void PrintedViews::startNext() {
    if (is_stopped_ || running_) return;
    for (const auto& [view, entry] : entries_) {
        if (!entry.isDue()) continue;
        running_ = std::make_unique<Running>();
        running_->view = view;
        running_->what = entry.wanted;
        try {
            thread_ = std::thread([this, running = running_.get()] {
                run(*running);
                QMetaObject::invokeMethod(
                    &rest_, [this] { finish(); }, Qt::QueuedConnection);
            });
        } catch (const std::system_error&) {
            running_.reset();
        }
        return;
    }
}

void PrintedViews::finish() {
    if (!thread_.joinable()) return;  // stopped in between
    thread_.join();
    const std::unique_ptr<Running> done = std::move(running_);
    keep(*done);
    if (!rest_.isActive()) startNext();
}

void PrintedViews::stop() {
    if (!running_) return;
    running_->is_given_up = true;
    thread_.join();
    running_.reset();
}

void PrintedViews::keep(const Running& done) {
    const auto found = entries_.find(done.view);
    if (found == entries_.end() || !(found->second.wanted == done.what)) return;
    Entry& entry = found->second;
    entry.print = done.print;
    entry.has_failed = !done.failure.isEmpty();
    if (entry.has_failed) say_(done.failure);
    if (entry.print.picture && entry.widget) entry.widget->update();
}
