// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "command_line.h"
#include "line_drawing/sheet.h"
#include "mesh_reading.h"

/// Draws the meshes together into a file, and says how large they are.
/// @throws laplacian_lines::Error with a sentence for users; std::bad_alloc
void draw_one(const CommandLine& commands);

/// Draws each mesh of a collection, as many at once as processors and memory allow, then a contact
/// sheet of all. Prints a line per mesh. Whether all were drawn.
/// @throws laplacian_lines::Error if there is nothing to draw or the folder is not writable
bool draw_collection(const CommandLine& commands);

/// Reads a mesh as the options say, says what of its file is skipped or missing, and refines it.
ReadMesh read_and_report(const std::string& file, const CommandLine& commands);

/// Draws the meshes together into the file. Returns the sheet and, of a collection, the mesh's view
/// for the contact sheet. @throws laplacian_lines::Error with a sentence for users; std::bad_alloc
std::vector<line_drawing::Sheet> draw_into(const std::string& file,
                                           const std::vector<ReadMesh>& meshes,
                                           const CommandLine& commands);
