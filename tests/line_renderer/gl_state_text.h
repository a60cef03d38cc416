// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// OpenGL state that drawing depends on, a line per name, and pending errors, which this clears.
QString glStateText();
