// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules.h"

namespace driver {

CommandTable allCommands() {
    CommandTable table;
    addWindowCommands(table);
    addActionCommands(table);
    addDialogCommands(table);
    addModalCommands(table);
    addDrawingCommands(table);
    addMouseCommands(table);
    addPictureCommands(table);
    addLogCommands(table);
    addMemoryCommands(table);
    addProbeCommands(table);
    addWatchCommands(table);
    return table;
}

}  // namespace driver
