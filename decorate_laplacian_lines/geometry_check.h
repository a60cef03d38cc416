// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

/// Its value changes with each press and release of a key or button anywhere in the program.
/// Between two of them a user either turns the camera or edits. GUI thread only.
class PressCount : public QObject {
public:
    PressCount();

    unsigned value() const { return value_; }

protected:
    bool eventFilter(QObject* receiver, QEvent* event) override;

private:
    unsigned value_ = 0;
};

class QWidget;

/// Decides when to compare a mesh with the geometry of its lines. Edit tools move vertices without
/// notifying decorations, but then either the camera has not moved since the last redraw, or a key
/// or button was used: such redraws always compare. While the camera is dragged, redraws compare
/// only now and then, for speed, and once after it has stopped. GUI thread only.
class GeometryCheck {
public:
    GeometryCheck();

    /// Whether to compare in this redraw of `widget`, always if null; if not, schedules one.
    bool is_due(const Eigen::Matrix4d& modelview, unsigned presses, QWidget* widget);

private:
    std::optional<Eigen::Matrix4d> modelview_;  ///< of the last redraw
    unsigned presses_ = 0;                      ///< until the last redraw
    QElapsedTimer since_check_;
    QTimer redraw_;
};
