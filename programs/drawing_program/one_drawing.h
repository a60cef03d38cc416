// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"

/// Reads the meshes, draws them together, writes the file, and with it the view for a contact
/// sheet, if that is wanted.
/// @throws laplacian_lines::Error with a sentence for users; std::bad_alloc.
void drawOne(const CommandLine& commands);
