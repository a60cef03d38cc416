// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.h"
#include "line_drawing/sheet.h"
#include "mesh_reading.h"

/// Reads a mesh as the options say, and says what of its file was skipped.
ReadMesh readAloud(const std::string& file, const CommandLine& commands);

std::vector<line_drawing::SourceMesh> sourcesOf(const std::vector<ReadMesh>& meshes);

/// Draws the meshes together into the file. Returns the sheet and, of a collection, the mesh's view
/// for the contact sheet. @throws laplacian_lines::Error with a sentence for users; std::bad_alloc
std::vector<line_drawing::Sheet> drawInto(const std::string& file,
                                          const std::vector<ReadMesh>& meshes,
                                          const CommandLine& commands);

/// Draws each mesh of a collection, as many at once as processors and memory allow, then a contact
/// sheet of all. Prints a line per mesh. Whether all were drawn.
/// @throws laplacian_lines::Error if there is nothing to draw or the folder is not writable
bool drawCollection(const CommandLine& commands);
