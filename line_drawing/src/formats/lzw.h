// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace line_drawing {

/// Compressed as PDF's filter LZWDecode reads it: less well than zlib does, but without a library,
/// and with the same bytes everywhere.
///
/// Source: T. A. Welch, "A Technique for High-Performance Data Compression", Computer (1984), with
/// the codes of PDF: 9 to 12 bits, each width from one code before it is needed.
std::string compressed(const std::string& bytes);

}  // namespace line_drawing
