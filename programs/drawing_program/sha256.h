// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

/// The SHA-256 of the bytes (FIPS 180-4), in lower hexadecimal.
std::string sha256_of(std::string_view bytes);
