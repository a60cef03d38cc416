// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A value of JSON (RFC 8259). At most one of the three is not empty.
struct Json {
    std::string text;  ///< of a string, in UTF-8; of numbers, true, false and null as written
    std::vector<Json> items;
    std::map<std::string, Json> members;
};

/// The value that the text begins with, whatever follows; nothing if it begins with none, or one
/// with more than eight values within each other.
std::optional<Json> json_in(std::string_view text);
