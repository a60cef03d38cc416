// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"

/// Reads the meshes, draws them together, writes the file, and with it the view for a contact
/// sheet, if that is wanted.
/// @throws laplacian_lines::Error with a sentence for users; std::bad_alloc.
void drawOne(const CommandLine& commands);

/// Draws each mesh of a collection by a process of its own, as many at once as there are
/// processors and as fit the memory, and then a contact sheet of all. What an earlier run has drawn
/// of the same mesh with the same options and program stays. Says in a line what became of each
/// mesh; whether all could be drawn.
/// @throws laplacian_lines::Error if there is nothing to draw or the folder cannot be written.
bool drawCollection(const CommandLine& commands);
