// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "line_drawing/sheet_options.h"

struct CommandLine {
    bool help = false;
    QString drawing;  ///< the file to write
    QString mesh;
    line_drawing::SheetOptions options;
};

/// @throws laplacian_lines::Error(InvalidOption)
CommandLine parseCommandLine(const QStringList& arguments);
const char* usage();
