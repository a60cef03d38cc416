// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <functional>

namespace driver {

/// Appends a line to the file: milliseconds that `action` takes until the view's OpenGL has drawn
/// all, by the clock, and in processor time of this thread and of all.
void appendTimes(const QString& file_name, const std::function<void()>& action);

}  // namespace driver
