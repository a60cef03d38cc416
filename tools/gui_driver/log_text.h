// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace driver {

QString logText();  // all of MeshLab's log panel; CommandError when there is none

}  // namespace driver
