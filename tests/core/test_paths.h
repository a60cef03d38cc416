// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

/// Where tests find files. In one source, so that all others compile to the same objects in every
/// folder.
namespace test_paths {

std::filesystem::path repository();

}  // namespace test_paths
