// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

/// Where tests find files. In one source, so that all others compile to the same objects in every
/// folder.
namespace test_paths {

std::filesystem::path repository();
std::string content(const std::filesystem::path& file);  ///< a relative one is the repository's

}  // namespace test_paths
