// SPDX-License-Identifier: GPL-3.0-or-later
#include "printed_views.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <new>
#include <utility>

#include "laplacian_lines/error.h"
#include "meshlab_host/camera.h"

namespace {

constexpr int milliseconds_at_rest = 150;

/// But for rounding: in floats, MeshLab computes that of a snapshot in another way.
bool areEqual(const Eigen::Matrix4d& projection, const Eigen::Matrix4d& other) {
    return meshlab_host::isOrthographic(projection) == meshlab_host::isOrthographic(other) &&
           projection.topRows<2>().isApprox(other.topRows<2>(), 1e-6);
}

/// But for colors, which a picture gets when it is shown.
bool areEqual(const DecorationParameters& chosen, const DecorationParameters& other) {
    const auto& table = decorationTable();
    return std::all_of(table.begin(), table.end(), [&](const auto& row) {
        return row.kind == laplacian_lines::OptionKind::Color || row.get(chosen) == row.get(other);
    });
}

line_drawing::SheetOptions sheetOptions(const DecorationParameters& chosen) {
    line_drawing::SheetOptions options;
    options.style = line_drawing::styleOnPaper(chosen.style);
    if (const auto azimuth = lightAzimuth(chosen))
        options.light = meshlab_host::towardsLight(*azimuth);
    if (chosen.appearance.hidden == line_renderer::HiddenLines::Dashed)
        options.hidden = line_drawing::HiddenLines::Dashed;
    const double factor = chosen.outline_width / DecorationParameters().outline_width;
    for (const auto outline : {line_drawing::LineClass::Outline, line_drawing::LineClass::Contour})
        options.pens[std::size_t(outline)] *= factor;
    return options;
}

}  // namespace

bool PrintedView::operator==(const PrintedView& other) const {
    return lines == other.lines && areEqual(chosen, other.chosen) && to_eye == other.to_eye &&
           areEqual(projection, other.projection) && window.size == other.window.size &&
           window.pixels_per_mm == other.window.pixels_per_mm;
}

PrintedViews::PrintedViews() {
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
        rest_.start(milliseconds_at_rest);  // for another view, whose drawing this has stopped
    }
    Print print = entry.print;
    entry.print.lack.clear();
    return print;
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
            running.what.window, sheetOptions(running.what.chosen),
            [&](double, const char*) { return !running.is_given_up; });
        running.print.milliseconds = 1e-6 * double(clock.nsecsElapsed());
    } catch (const std::bad_alloc&) {
        running.print.lack = "There is not enough memory for the printed drawing.";
    } catch (const laplacian_lines::Error& error) {
        if (error.code() != laplacian_lines::ErrorCode::Cancelled)
            running.print.lack = QString::fromUtf8(error.what());
    } catch (const std::exception& error) {
        running.print.lack = QString::fromUtf8(error.what());
    }
}

void PrintedViews::startNext() {
    if (is_stopped_ || running_) return;
    for (const auto& [view, entry] : entries_) {
        if (!entry.isDue()) continue;
        try {
            auto next = std::make_unique<Running>();
            next->view = view;
            next->what = entry.wanted;
            thread_ = std::thread([this, running = next.get()] {
                run(*running);
                running->is_over = true;
                QMetaObject::invokeMethod(
                    &rest_, [this] { finish(); }, Qt::QueuedConnection);
            });
            running_ = std::move(next);
        } catch (const std::exception&) {  // no thread: lines stay live
        }
        return;
    }
}

void PrintedViews::finish() {
    if (!running_ || !running_->is_over) return;  // it was stopped, and perhaps another began
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
    entry.has_failed = !done.print.lack.isEmpty();
    if (std::exchange(entry.told, done.print.lack) == done.print.lack) entry.print.lack.clear();
    if ((entry.print.picture || entry.has_failed) && entry.widget) entry.widget->update();
}
