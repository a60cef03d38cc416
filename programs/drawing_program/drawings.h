// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"

/// Draws the meshes together into a file, and says how large they are.
/// @throws laplacian_lines::Error with a sentence for users; std::bad_alloc
void draw_one(const CommandLine& commands);

/// Draws each mesh of a collection, as many at once as processors and memory allow, then a contact
/// sheet of all. Prints a line per mesh. Whether all were drawn.
/// @throws laplacian_lines::Error if there is nothing to draw or the folder is not writable
bool draw_collection(const CommandLine& commands);
