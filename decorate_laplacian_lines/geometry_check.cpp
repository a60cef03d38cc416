// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry_check.h"

#include <QWidget>

namespace {

constexpr qint64 milliseconds_between_checks = 250;

}  // namespace

GeometryCheck::GeometryCheck() : redraw_(std::make_unique<QTimer>()) {
    redraw_->setSingleShot(true);
    since_check_.start();
}

bool GeometryCheck::isDue(const Eigen::Matrix4d& modelview, unsigned presses, QWidget* widget) {
    const bool only_moved = modelview_ && *modelview_ != modelview && presses == presses_;
    modelview_ = modelview;
    presses_ = presses;
    const qint64 wait = milliseconds_between_checks - since_check_.elapsed();
    if (!widget || !only_moved || wait <= 0) {
        redraw_->stop();
        since_check_.start();
        return true;
    }
    if (!redraw_->isActive()) {
        redraw_->disconnect();
        QObject::connect(redraw_.get(), &QTimer::timeout, widget, [widget] { widget->update(); });
        redraw_->start(int(wait));
    }
    return false;
}
