// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

/// Where tests find files. In one source, so that all others compile to the same objects in every
/// folder.
namespace places {

std::filesystem::path repository();

/// An OBJ or PLY file beside the repository or fetched by ./run; empty if there is none.
std::filesystem::path scanned_model(const std::string& name);

}  // namespace places
