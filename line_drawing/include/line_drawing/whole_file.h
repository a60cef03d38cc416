// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace line_drawing {

/// Writes a file at once and whole: beside its place, flushed to the disk, then renamed. Links are
/// followed. Devices and pipes are written into, never replaced.
/// @throws laplacian_lines::Error(InvalidOption) naming the file and the reason. Then a file that
/// was there is as it was, and nothing is left beside it.
void writeWhole(const std::string& file, const std::string& data);

/// Before much work is done: whether the file could be written now. Writes nothing.
/// @throws laplacian_lines::Error(InvalidOption)
void checkWritable(const std::string& file);

}  // namespace line_drawing
