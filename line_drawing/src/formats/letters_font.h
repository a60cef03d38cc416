// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace line_drawing {

/// The bytes of ../../letters/letters.ttf; its source is written by CMake.
extern const std::string_view letters_font;

}  // namespace line_drawing
