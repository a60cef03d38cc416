// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <functional>

namespace driver {

/// Appends to the file the milliseconds until the view's OpenGL has drawn all of `action`: by the
/// clock, and processor time of this thread and of all.
void appendTimes(const QString& file_name, const std::function<void()>& action);

}  // namespace driver
