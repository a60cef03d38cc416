// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

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
