// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace line_drawing {

// Names of files are bytes, on Windows UTF-8.

/// Writes a file atomically: to a temporary file beside it, flushed, then renamed. Follows links;
/// writes into devices and pipes, never replaces them.
/// @throws laplacian_lines::Error(InvalidOption) naming file and reason; an existing file is as it
/// was, and nothing is left beside it
void write_atomically(const std::string& file, const std::string& data);

/// Checks, before the work begins, that the file can be written, and leaves nothing behind.
/// @throws laplacian_lines::Error(InvalidOption)
void check_writable(const std::string& file);

}  // namespace line_drawing
