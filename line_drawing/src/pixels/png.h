// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pixels/canvas.h"

namespace line_drawing {

/// The rows of a picture, each after a byte that says that it is not filtered, as a stream of
/// zlib's format (RFC 1950, 1951): runs of one gray, and Huffman's code. Smaller for lines on white
/// than what zlib itself makes of them, and without a library, whose version would decide the
/// bytes.
std::string deflatedRows(const Canvas& canvas);

/// A picture as PNG of 256 grays.
std::string inPng(const Canvas& canvas, int dots_per_metre);

}  // namespace line_drawing
