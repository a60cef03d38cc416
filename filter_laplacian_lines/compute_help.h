// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// The filter's help for MeshLab's dialog and documentation, HTML.
QString computeHelp();
