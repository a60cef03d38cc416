// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace driver {

/// The state of the current OpenGL context as far as drawing depends on it, one line a name, with
/// the errors that are pending (and are cleared by this).
QString glStateText();

}  // namespace driver
