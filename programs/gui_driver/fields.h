// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>
#include "command_table.h"

namespace driver {

// LABEL = VALUE: sets the container's field with this label as a user would. CommandError if there
// is none or it refuses. Check box: on or off; combo box: text or number of an entry; color:
// #rrggbb or a name.
void setField(QWidget* container, const Command& command);

}  // namespace driver
