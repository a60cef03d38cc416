// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// The filters' help for MeshLab's dialogs and documentation, HTML.
QString computeHelp();
QString polylineHelp();
QString drawingHelp();
