// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

/// Where tests find files. In one source, so that all others compile to the same objects in every
/// folder.
namespace places {

std::filesystem::path repository();

}  // namespace places
