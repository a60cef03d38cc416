// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pixels/canvas.h"

namespace line_drawing {

/// The rows, each after a byte for "not filtered", as a zlib stream (RFC 1950, 1951) of runs of one
/// gray in Huffman's code. For lines on white this is smaller than zlib's output, and no library's
/// version decides the bytes.
std::string deflatedRows(const Canvas& canvas);

/// 256 grays.
std::string inPng(const Canvas& canvas, int dots_per_metre);

}  // namespace line_drawing
