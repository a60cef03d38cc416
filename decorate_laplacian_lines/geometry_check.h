// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

/// Counts the presses and releases of keys and buttons anywhere in the program, as long as it
/// lives. Between two of them a user does one thing: turns the camera or edits, not both. GUI
/// thread only.
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

/// When to compare the geometry of a mesh that a view shows with that of its lines. Edit tools move
/// vertices without telling decorations, but then MeshLab redraws the view for another reason than
/// the camera, or a key or button was pressed or released before the camera moved: such a redraw
/// always compares. Turning a large mesh must be smooth, so while one drag moves the camera it is
/// done now and then, and once more when the camera has stopped. GUI thread only.
class GeometryCheck {
public:
    GeometryCheck();

    /// Whether to do it in this redraw, of `widget`, with this modelview matrix, after so many
    /// presses. If not, the widget is redrawn soon, unless it is done before.
    bool isDue(const Eigen::Matrix4d& modelview, unsigned presses, QWidget* widget);

private:
    std::optional<Eigen::Matrix4d> modelview_;  ///< of the last redraw
    unsigned presses_ = 0;                      ///< until the last redraw
    QElapsedTimer since_check_;
    std::unique_ptr<QTimer> redraw_;
};
