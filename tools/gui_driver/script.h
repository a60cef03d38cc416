// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QVector>
#include "command_table.h"

namespace driver {

Command parseLine(const QString& text);

// One command a line; empty lines and lines that start with # are skipped. CommandError when
// unreadable.
QVector<Command> readScript(const QString& file_name);

}  // namespace driver
