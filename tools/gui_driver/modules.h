// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "command_table.h"

namespace driver {

// Each module adds its commands to the table; modules.cpp lists them all. A new module is a file of
// its own, a line here and a line there.
void addWindowCommands(CommandTable& table);  // window_commands.cpp: views, size, camera, layers
void addActionCommands(
    CommandTable& table);  // action_commands.cpp: menus, filter dialog, decoration parameters
void addDialogCommands(CommandTable& table);  // dialog_commands.cpp: sizes and states
void addModalCommands(
    CommandTable& table);  // modal_commands.cpp: boxes that wait for an answer, snapshots
void addDrawingCommands(
    CommandTable& table);                    // drawing_commands.cpp: what makes a drawing of a mesh
void addMouseCommands(CommandTable& table);  // mouse_commands.cpp
void addPictureCommands(CommandTable& table);  // picture_commands.cpp
void addLogCommands(CommandTable& table);      // log_commands.cpp
void addMemoryCommands(CommandTable& table);   // memory_commands.cpp
void addProbeCommands(CommandTable& table);    // probe_commands.cpp
void addWatchCommands(CommandTable& table);    // watch_commands.cpp

CommandTable allCommands();

}  // namespace driver
