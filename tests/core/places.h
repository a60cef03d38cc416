// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

/// Where the files are that tests read. In a source of its own, so that all others compile to the
/// same objects in every folder.
namespace places {

std::filesystem::path repository();

/// An OBJ or PLY file of this name that lies beside the repository or that ./run has fetched; empty
/// if there is none.
std::filesystem::path scanned_model(const std::string& name);

}  // namespace places
